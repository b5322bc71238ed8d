// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;

/**
 * The tracks of all circles of a recording, found by id. Memory follows the flights that are kept,
 * not the ids that were given: of removed circles as many flights are kept in all as the largest
 * number of circles that were there at once may have, and those removed first are dropped first.
 */
final class FlightHistories {

  private static final int FIRST_ROOM = 16;

  private final int most;

  /** The ids of all tracks, ascending; tracks that were dropped are null. */
  private int[] ids = new int[FIRST_ROOM];

  private FlightHistory[] tracks = new FlightHistory[FIRST_ROOM];
  private int size;
  private int dropped;

  /** Where an id was found last: the next one asked for is often the same, or the next one. */
  private int found;

  /** The ids of circles that were removed, in that order, and how many flights are kept of them. */
  private final Deque<Integer> removed = new ArrayDeque<>();

  private long flightsOfRemoved;

  private int present;
  private int mostPresent;

  /** The earliest time of which everything is known, once something was dropped. */
  private double start = Double.NEGATIVE_INFINITY;

  /** Of so many flights of each circle at most. */
  FlightHistories(int most) {
    this.most = most;
  }

  double start() {
    return start;
  }

  /** The track of a circle, for any number; null if there is none. */
  FlightHistory get(int id) {
    int k = find(id);
    return k < 0 ? null : tracks[k];
  }

  /** Adds a flight of a circle; the first one of each circle comes in the order of their ids. */
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

  /** Ends the track of a circle. */
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

  /** Makes the arrays dense anew. */
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

  /** The place of an id, below 0 if there is none. */
  private int find(int id) {
    if (id >= 0 && id < size && ids[id] == id) {
      return id; // as long as none was dropped
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
