// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ObstacleKind;
import dev.carom.World;

/**
 * Kinetic energy over one step, as the responses allow: of each circle, or of all together if they
 * collide. Restitutions up to 1 never add any; where all are 1 and nothing halts or jams, none is
 * lost.
 */
final class EnergyCheck {

  /** Relative, of an impact. */
  private static final double ROUNDING = 0x1p-48;

  /** At so many impacts at one place a world begins to take motion away: see World. */
  private static final int PATIENCE = 31;

  private final World world;
  private final Rules rules;
  private final double unit;
  private double[] before = new double[0];
  private long impacts;

  EnergyCheck(World world, Rules rules, double speedUnit, long impacts) {
    this.impacts = impacts;
    this.world = world;
    this.rules = rules;
    unit = speedUnit;
  }

  /** Notes the state at the start of a step. */
  void begin() {
    before = energies();
  }

  /** Looks at what the step made of it. */
  void end() throws FindingException {
    int rows = world.impacts().size();
    impacts += rows;
    double[] after = energies();
    double slack = ROUNDING * (rows + 4);
    for (int i = 0; i < after.length; i++) {
      boolean gained = after[i] > before[i] * (1 + slack) && !rules.mayGain() && !isDriven();
      boolean lost =
          after[i] < before[i] * (1 - slack)
              && !rules.mayLose()
              && !isDriven()
              && impacts <= PATIENCE;
      if (gained || lost) {
        throw new FindingException(
            "energy %s went from %s to %s in %d impacts"
                .formatted(
                    world.scene().collide() ? "of all" : "of circle " + i,
                    before[i],
                    after[i],
                    rows));
      }
    }
  }

  private boolean isDriven() {
    return world.scene().collide() && rules.hasInfiniteMasses();
  }

  /** In the session's own unit of speed, so that squares stay in range. */
  private double[] energies() {
    int end = world.idEnd(ObstacleKind.CIRCLE);
    double[] each = new double[world.scene().collide() ? 1 : end];
    for (int i = 0; i < end; i++) {
      if (world.contains(ObstacleKind.CIRCLE, i)) {
        double vx = world.vx(i) / unit;
        double vy = world.vy(i) / unit;
        double mass = world.scene().collide() ? world.mass(i) : 1;
        each[world.scene().collide() ? 0 : i] += mass * (vx * vx + vy * vy);
      }
    }
    return each;
  }
}
