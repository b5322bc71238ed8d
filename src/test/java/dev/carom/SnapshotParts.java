// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.SavedFlights;
import dev.carom.internal.state.WorldState;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;

/** The parts of a snapshot in readable form: a comparison that fails shows which one differs. */
final class SnapshotParts {

  private SnapshotParts() {}

  static Map<String, Object> of(Snapshot snapshot) {
    WorldState state = snapshot.state;
    SavedFlights flights = state.flights();
    int[] ids = state.registry().ids();
    Map<String, Object> parts = new LinkedHashMap<>();
    parts.put("now", state.now());
    parts.put("collide", state.collide());
    parts.put("obstacles", state.obstacles());
    parts.put("limits", state.limits().largest() + ", " + state.limits().least());
    parts.put("id limit", state.registry().idLimit());
    parts.put("tail of edit", flights.tailOfEdit);
    for (int k = 0; k < ids.length; k++) {
      int n = k * SavedFlights.NUMBERS;
      int c = k * SavedFlights.CODES;
      parts.put(
          "circle " + ids[k],
          Arrays.toString(Arrays.copyOfRange(flights.numbers, n, n + SavedFlights.NUMBERS))
              + Arrays.toString(Arrays.copyOfRange(flights.codes, c, c + SavedFlights.CODES))
              + (flights.jams == null || flights.jams[k] == null
                  ? ""
                  : Arrays.toString(flights.jams[k].entries())));
    }
    parts.put("registry", state.registry());
    return parts;
  }
}
