// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.FlightTable;
import dev.carom.internal.state.WorldState;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;

/** The parts of a snapshot in readable form: a comparison that fails shows which one differs. */
final class SnapshotParts {

  private SnapshotParts() {}

  static Map<String, Object> of(Snapshot snapshot) {
    WorldState state = snapshot.state;
    FlightTable flights = state.flights();
    int[] ids = state.registry().ids();
    Map<String, Object> parts = new LinkedHashMap<>();
    parts.put("now", state.now());
    parts.put("collide", state.collide());
    parts.put("obstacles", state.obstacles());
    parts.put("limits", state.limits().largest() + ", " + state.limits().least());
    parts.put("id limit", state.registry().idLimit());
    parts.put("tail of edit", state.tailOfEdit());
    for (int k = 0; k < ids.length; k++) {
      parts.put(
          "circle " + ids[k],
          columns(flights, k)
              + (flights.jam(k) == null ? "" : Arrays.toString(flights.jam(k).entries())));
    }
    parts.put("registry", state.registry());
    return parts;
  }

  private static String columns(FlightTable flights, int k) {
    StringBuilder text = new StringBuilder();
    for (int group = 0; group < flights.numbers().length; group++) {
      double[] numbers = flights.numbers()[group];
      if (numbers != null) {
        int n = FlightTable.width(group);
        text.append(Arrays.toString(Arrays.copyOfRange(numbers, k * n, k * n + n)));
      }
    }
    int c = FlightTable.CODES;
    text.append(Arrays.toString(Arrays.copyOfRange(flights.codes, k * c, k * c + c)));
    return text.toString();
  }
}
