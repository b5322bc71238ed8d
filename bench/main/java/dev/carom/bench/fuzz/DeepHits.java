// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Outcome;
import dev.carom.Timeline;
import dev.carom.World;
import java.util.BitSet;

/**
 * The circles that in a step, or last before it, hit an obstacle that they overlapped, or were
 * beyond a wall. With gravity such a circle may come back to the same depth, also in a later step.
 */
final class DeepHits {

  /** An overlap of no more than so much of the sizes is rounding. */
  private static final double ROUNDING = 0x1p-50;

  /** After the last impact read. */
  private final BitSet deep = new BitSet();

  /** At some time of the step read last. */
  private final BitSet inStep = new BitSet();

  /** Whether a circle was deep in something in the step read last. */
  boolean isDeep(int circle) {
    return inStep.get(circle);
  }

  /** Takes all circles for such, after a step that was not looked at. */
  void assumeOf(World world) {
    deep.set(0, world.idLimit(Kind.CIRCLE));
    inStep.or(deep);
  }

  /** Reads the impacts of a step. */
  void read(World world, Timeline timeline) {
    inStep.clear();
    inStep.or(deep);
    ImpactLog log = world.impacts();
    for (int row = 0; row < log.size(); row++) {
      if (log.outcome(row) != Outcome.SENSED) {
        double t = log.time(row);
        int i = log.circle(row);
        boolean pair = log.kind(row) == Kind.CIRCLE;
        double x = pair ? timeline.x(log.id(row), t) : log.x(row);
        double y = pair ? timeline.y(log.id(row), t) : log.y(row);
        double reach = world.radius(i) + (pair ? world.radius(log.id(row)) : 0);
        double size = Math.abs(x) + Math.abs(y) + reach;
        double distance =
            log.nx(row) * (timeline.x(i, t) - x) + log.ny(row) * (timeline.y(i, t) - y);
        boolean isDeep = distance < reach - ROUNDING * size;
        note(i, isDeep, !pair);
        if (pair) {
          note(log.id(row), isDeep, false);
        }
      }
    }
  }

  /**
   * Notes an impact. A collision ends nothing: a circle that slides along an obstacle may slide on.
   */
  private void note(int circle, boolean isDeep, boolean endsLast) {
    if (isDeep) {
      deep.set(circle);
      inStep.set(circle);
    } else if (endsLast) {
      deep.clear(circle);
    }
  }
}
