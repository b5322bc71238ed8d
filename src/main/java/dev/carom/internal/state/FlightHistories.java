// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;

/**
 * The flight histories of all circles of a recording, by id. Memory depends on the flights that are
 * kept, not on the ids that were given. All removed circles together keep at most as many flights
 * as the largest number of circles that ever existed at once may keep. Those removed first are
 * dropped first.
 */
final class FlightHistories {

  private static final int FIRST_ROOM = 16;

  private final int most;

  /** The ids of all histories, ascending. A dropped history is null. */
  private int[] ids = new int[FIRST_ROOM];

  private FlightHistory[] tracks = new FlightHistory[FIRST_ROOM];
  private int size;
  private int dropped;

  /** The index found last. The next id asked for is often the same, or the one after it. */
  private int found;

  /** The ids of removed circles in order of removal, and the number of flights kept of them. */
  private final Deque<Integer> removed = new ArrayDeque<>();

  private long flightsOfRemoved;

  private int present;
  private int mostPresent;

  /** The earliest time from which all histories are complete, once something was dropped. */
  private double start = Double.NEGATIVE_INFINITY;

  /** Creates histories of at most that many flights per circle. */
  FlightHistories(int most) {
    this.most = most;
  }

  double start() {
    return start;
  }

  /** The history of a circle, for any int; null if there is none. */
  FlightHistory get(int id) {
    int k = find(id);
    return k < 0 ? null : tracks[k];
  }

  /**
   * Adds a flight of a circle. The first flights of circles must be added in order of their ids.
   */
  void add(int id, double[] numbers, int k) {
    FlightHistory track = get(id);
    if (track == null) {
      track = create(id);
    }
    track.add(numbers, k);
    if (track.hasDropped()) {
      start = Math.max(start, track.start());
    }
  }

  private FlightHistory create(int id) {
    if (size == ids.length) {
      ids = Arrays.copyOf(ids, 2 * size);
      tracks = Arrays.copyOf(tracks, 2 * size);
    }
    present++;
    mostPresent = Math.max(mostPresent, present);
    ids[size] = id;
    tracks[size] = new FlightHistory(most);
    return tracks[size++];
  }

  /** Ends the history of a circle. */
  void remove(int id, double now) {
    FlightHistory track = get(id);
    track.end(now);
    present--;
    flightsOfRemoved += track.size();
    removed.add(id);
    while (flightsOfRemoved > (long) most * mostPresent) {
      dropFirst();
    }
  }

  private void dropFirst() {
    int k = find(removed.remove());
    flightsOfRemoved -= tracks[k].size();
    start = Math.max(start, tracks[k].end());
    tracks[k] = null;
    dropped++;
    if (dropped > size / 2) {
      pack();
    }
  }

  /** Compacts the arrays. */
  private void pack() {
    int left = size - dropped;
    int[] idsLeft = new int[left + FIRST_ROOM];
    FlightHistory[] tracksLeft = new FlightHistory[left + FIRST_ROOM];
    int to = 0;
    for (int k = 0; k < size; k++) {
      if (tracks[k] != null) {
        idsLeft[to] = ids[k];
        tracksLeft[to++] = tracks[k];
      }
    }
    ids = idsLeft;
    tracks = tracksLeft;
    size = left;
    dropped = 0;
    found = 0;
  }

  /** The index of an id; negative if there is none. */
  private int find(int id) {
    if (id >= 0 && id < size && ids[id] == id) {
      return id; // true as long as no history was dropped
    }
    if (found + 1 < size && ids[found + 1] == id) {
      found++;
    } else if (found >= size || ids[found] != id) {
      int k = Arrays.binarySearch(ids, 0, size, id);
      if (k < 0) {
        return k;
      }
      found = k;
    }
    return found;
  }
}
