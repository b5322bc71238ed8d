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
    boolean collide = world.scene().collide();
    double[] each = new double[collide ? 1 : world.idEnd(ObstacleKind.CIRCLE)];
    for (int id : world.ids(ObstacleKind.CIRCLE)) {
      double vx = world.vx(id) / unit;
      double vy = world.vy(id) / unit;
      double mass = collide ? world.mass(id) : 1;
      each[collide ? 0 : id] += mass * (vx * vx + vy * vy);
    }
    return each;
  }
}
