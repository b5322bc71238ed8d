// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Outcome;
import dev.carom.World;
import java.util.HashMap;
import java.util.Map;

/**
 * The circles over which moving obstacles may pass: those that were jammed, as long as they stand
 * still.
 */
final class PassedOver {

  private World world;

  /** Since when each of them is jammed. */
  private final Map<Integer, Double> jammed = new HashMap<>();

  void enter(World entered) {
    world = entered;
  }

  /** Reads who was jammed in a step. */
  void read(ImpactLog log) {
    for (int row = 0; row < log.size(); row++) {
      if (log.outcome(row) == Outcome.JAMMED) {
        jammed.putIfAbsent(log.circle(row), log.time(row));
        if (log.kind(row) == Kind.CIRCLE) {
          jammed.putIfAbsent(log.id(row), log.time(row));
        }
      }
    }
  }

  /** Whether an obstacle that moves may pass over a circle in a part of its flight. */
  boolean mayPass(Flight f) {
    Double since = jammed.get(f.circle());
    return since != null && since <= f.from() && f.isStanding();
  }

  /** Whether a circle was jammed, and has not moved since when a step was over. */
  boolean wasJammed(int circle) {
    return jammed.containsKey(circle);
  }

  /** Forgets those that move again, when a step is over. */
  void end() {
    jammed.keySet().removeIf(id -> !stands(id));
  }

  private boolean stands(int id) {
    return world.contains(Kind.CIRCLE, id) && world.vx(id) == 0 && world.vy(id) == 0;
  }
}
