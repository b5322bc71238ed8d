// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The flight histories of all circles of a recording, by id. Those of removed circles are dropped
 * once the recording does not go back as far any more.
 */
final class FlightHistories {

  private static final int FIRST_ROOM = 16;

  /** The ids of all histories, ascending. */
  private int[] ids = new int[FIRST_ROOM];

  private FlightHistory[] tracks = new FlightHistory[FIRST_ROOM];
  private int size;

  /** The earliest time at which a circle was removed whose history is kept. */
  private double removed = Double.POSITIVE_INFINITY;

  /** One more than the largest id that was given before the first, or of which all is dropped. */
  private int idLimit;

  /**
   * Begins without histories.
   *
   * @param idLimit one more than the largest id that was given so far
   */
  FlightHistories(int idLimit) {
    this.idLimit = idLimit;
  }

  /** The history of a circle, for any int; null if there is none. */
  FlightHistory get(int id) {
    // The first case is that of most recordings: no history was dropped.
    boolean isAtId = id >= 0 && id < size && ids[id] == id;
    int k = isAtId ? id : Arrays.binarySearch(ids, 0, size, id);
    return k < 0 ? null : tracks[k];
  }

  /** The history of a circle, which may be a new one: then its id is larger than all others. */
  FlightHistory of(int id) {
    FlightHistory known = get(id);
    return known == null ? create(id) : known;
  }

  private FlightHistory create(int id) {
    if (size == ids.length) {
      ids = Arrays.copyOf(ids, 2 * size);
      tracks = Arrays.copyOf(tracks, 2 * size);
    }
    ids[size] = id;
    tracks[size] = new FlightHistory();
    return tracks[size++];
  }

  /** Ends the history of a circle. */
  void remove(int id, double now) {
    get(id).end(now);
    removed = Math.min(removed, now);
  }

  /** Gives back the room for flights to come. */
  void trim() {
    for (int k = 0; k < size; k++) {
      tracks[k].trim();
    }
  }

  /** Drops the circles that were removed by a time. */
  void forget(double time) {
    if (removed <= time) {
      dropUntil(time);
    }
  }

  private void dropUntil(double time) {
    int before = size;
    size = 0;
    removed = Double.POSITIVE_INFINITY;
    for (int k = 0; k < before; k++) {
      if (tracks[k].end() <= time) {
        idLimit = Math.max(idLimit, ids[k] + 1);
      } else {
        removed = Math.min(removed, tracks[k].end());
        ids[size] = ids[k];
        tracks[size++] = tracks[k];
      }
    }
    Arrays.fill(tracks, size, before, null);
  }

  /** The ids of the circles that existed at a time, ascending. */
  int[] idsAt(double t) {
    return IntStream.range(0, size)
        .filter(k -> tracks[k].start() <= t && t < tracks[k].end())
        .map(k -> ids[k])
        .toArray();
  }

  /** One more than the largest id that was given by a time. */
  int idLimitAt(double t) {
    int last = size - 1;
    while (last >= 0 && tracks[last].start() > t) {
      last--;
    }
    return last < 0 ? idLimit : Math.max(idLimit, ids[last] + 1);
  }
}
