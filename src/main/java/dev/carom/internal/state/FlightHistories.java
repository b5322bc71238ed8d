// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The flight histories of all circles of a recording, by id. Memory depends on the flights that are
 * kept, not on the ids that were given. All removed circles together keep at most as many flights
 * as the largest number of circles that ever existed at once may keep. Those removed first are
 * dropped first.
 */
final class FlightHistories {

  private static final int FIRST_ROOM = 16;

  /** The ids of all histories, ascending. A dropped history is null. */
  private int[] ids = new int[FIRST_ROOM];

  private FlightHistory[] tracks = new FlightHistory[FIRST_ROOM];
  private int size;
  private int dropped;

  /** The index found last. The next id asked for is often the same, or the one after it. */
  private int found;

  private final int most;
  private final Remains remains;

  /** One more than the largest id that was given before the first, or of which all is dropped. */
  private int idLimit;

  /** The earliest time from which all histories are complete, once something was dropped. */
  private double start = Double.NEGATIVE_INFINITY;

  /**
   * Creates histories of at most that many flights per circle.
   *
   * @param idLimit one more than the largest id that was given so far
   */
  FlightHistories(int most, int idLimit) {
    this.most = most;
    remains = new Remains(most);
    this.idLimit = idLimit;
  }

  double start() {
    return start;
  }

  /** The history of a circle, for any int; null if there is none. */
  FlightHistory get(int id) {
    int k = find(id);
    return k < 0 ? null : tracks[k];
  }

  /** Makes {@link #start} later, as something before a time was dropped. */
  void drop(double time) {
    start = Math.max(start, time);
  }

  /** Adds the history of a new circle. Circles must be added in order of their ids. */
  FlightHistory create(int id) {
    if (size == ids.length) {
      ids = Arrays.copyOf(ids, 2 * size);
      tracks = Arrays.copyOf(tracks, 2 * size);
    }
    remains.appear(1);
    ids[size] = id;
    tracks[size] = new FlightHistory(most);
    return tracks[size++];
  }

  /** The ids of the circles that existed at a time, ascending. */
  int[] idsAt(double t) {
    return IntStream.range(0, createdBy(t))
        .filter(k -> tracks[k] != null && t < tracks[k].end())
        .map(k -> ids[k])
        .toArray();
  }

  /** One more than the largest id that was given by a time. */
  int idLimitAt(double t) {
    int created = createdBy(t);
    return created == 0 ? idLimit : Math.max(idLimit, ids[created - 1] + 1);
  }

  /** The number of listed circles that were created by a time: those with the least ids. */
  private int createdBy(double t) {
    int low = 0;
    int high = size;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (tracks[middle] == null || tracks[middle].start() <= t) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Ends the history of a circle. */
  void remove(int id, double now) {
    FlightHistory track = get(id);
    track.end(now);
    remains.remove(id, track.size());
    while (remains.isFull()) {
      dropFirst();
    }
  }

  private void dropFirst() {
    int k = find(remains.first());
    remains.dropFirst(tracks[k].size());
    idLimit = Math.max(idLimit, ids[k] + 1);
    drop(tracks[k].end());
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
