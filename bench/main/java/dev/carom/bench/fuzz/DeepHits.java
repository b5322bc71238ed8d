// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.ObstacleKind;
import dev.carom.Outcome;
import dev.carom.Timeline;
import dev.carom.World;
import java.util.BitSet;

/**
 * The circles whose last impact was with something that they overlapped, or beyond a wall. With
 * gravity such a circle may come back to the same depth, also in a later step.
 */
final class DeepHits {

  /** An overlap of no more than so much of the sizes is rounding. */
  private static final double ROUNDING = 0x1p-50;

  private final BitSet deep = new BitSet();

  /** Whether the last impact of a circle was a deep one. */
  boolean isDeep(int circle) {
    return deep.get(circle);
  }

  /** Takes all circles for such, after a step that was not looked at. */
  void assumeOf(World world) {
    deep.set(0, world.idLimit(ObstacleKind.CIRCLE));
  }

  /** Reads the impacts of a step. */
  void read(World world, Timeline timeline) {
    ImpactLog log = world.impacts();
    for (int row = 0; row < log.size(); row++) {
      if (log.outcome(row) != Outcome.SENSED) {
        double t = log.time(row);
        int i = log.circle(row);
        boolean pair = log.kind(row) == ObstacleKind.CIRCLE;
        double x = pair ? timeline.x(log.id(row), t) : log.x(row);
        double y = pair ? timeline.y(log.id(row), t) : log.y(row);
        double reach = world.radius(i) + (pair ? world.radius(log.id(row)) : 0);
        double size = Math.abs(x) + Math.abs(y) + reach;
        double distance =
            log.nx(row) * (timeline.x(i, t) - x) + log.ny(row) * (timeline.y(i, t) - y);
        note(i, distance < reach - ROUNDING * size);
        if (pair) {
          note(log.id(row), deep.get(i));
        }
      }
    }
  }

  private void note(int circle, boolean isDeep) {
    deep.set(circle, isDeep);
  }
}
