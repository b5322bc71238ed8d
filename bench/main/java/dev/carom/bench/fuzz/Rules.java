// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ObstacleKind;
import dev.carom.Response;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** What a world does not tell about its things: which are sensors or one-way, and what was set. */
final class Rules {

  private final Map<ObstacleKind, Set<Integer>> sensors = new EnumMap<>(ObstacleKind.class);
  private final Set<Integer> oneWay = new HashSet<>();

  /** Whether some impact may add energy. */
  private boolean bumpers;

  /** Whether some impact may take energy away. */
  private boolean lossy;

  private boolean infiniteMasses;

  Rules() {
    for (ObstacleKind kind : ObstacleKind.values()) {
      sensors.put(kind, new HashSet<>());
    }
  }

  void setRestitution(double e) {
    bumpers |= e > 1;
    lossy |= e < 1;
  }

  void setResponse(ObstacleKind kind, int id, Response response) {
    if (response == Response.SENSOR) {
      sensors.get(kind).add(id);
    } else {
      sensors.get(kind).remove(id);
    }
    lossy |= response == Response.HALT;
  }

  void setOneWay(int line, boolean is) {
    if (is) {
      oneWay.add(line);
    } else {
      oneWay.remove(line);
    }
  }

  void setMass(double mass) {
    infiniteMasses |= mass == Double.POSITIVE_INFINITY;
  }

  boolean isSensor(ObstacleKind kind, int id) {
    return sensors.get(kind).contains(id);
  }

  boolean isOneWay(int line) {
    return oneWay.contains(line);
  }

  boolean mayGain() {
    return bumpers;
  }

  boolean mayLose() {
    return lossy;
  }

  /** A circle that nothing deflects gives energy to what it pushes. */
  boolean hasInfiniteMasses() {
    return infiniteMasses;
  }
}
