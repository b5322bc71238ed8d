// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.ObstacleKind;
import dev.carom.Outcome;
import dev.carom.Vec2;
import dev.carom.World;

/**
 * Kinetic energy over one step: of each circle, or of all finite masses together if they collide.
 * It grows only if a row bounced with a restitution above 1, or met an infinite mass or a moving
 * obstacle. It is lost only if a row has a restitution below 1 or another outcome than a bounce, or
 * met one of those.
 */
final class EnergyCheck {

  /** Relative, of an impact. */
  private static final double ROUNDING = 0x1p-48;

  private final World world;
  private final double unit;
  private double[] before = new double[0];

  EnergyCheck(World world, double speedUnit) {
    this.world = world;
    unit = speedUnit;
  }

  /** Notes the state at the start of a step. */
  void begin() {
    before = energies();
  }

  /** Compares the state at the end of the step. */
  void end() throws FindingException {
    int rows = world.impacts().size();
    double[] after = energies();
    boolean[] mayGain = new boolean[after.length];
    boolean[] mayLose = new boolean[after.length];
    for (int row = 0; row < rows; row++) {
      int i = world.scene().collide() ? 0 : world.impacts().circle(row);
      mayGain[i] |= mayGain(row);
      mayLose[i] |= mayLose(row);
    }
    double slack = ROUNDING * (rows + 4);
    for (int i = 0; i < after.length; i++) {
      boolean gained = after[i] > before[i] * (1 + slack) && !mayGain[i];
      boolean lost = after[i] < before[i] * (1 - slack) && !mayLose[i];
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

  private boolean mayGain(int row) {
    boolean bounced = world.impacts().outcome(row) == Outcome.BOUNCED;
    return (bounced && restitution(row) > 1) || meetsInfinite(row) || meetsMoving(row);
  }

  private boolean mayLose(int row) {
    return switch (world.impacts().outcome(row)) {
      case SENSED, PASSED -> false;
      case BOUNCED -> restitution(row) < 1 || meetsInfinite(row) || meetsMoving(row);
      default -> true;
    };
  }

  private double restitution(int row) {
    ImpactLog log = world.impacts();
    return world.restitution(ObstacleKind.CIRCLE, log.circle(row))
        * world.restitution(log.kind(row), log.id(row));
  }

  /** Whether one of two circles has infinite mass, which gives or takes any energy. */
  private boolean meetsInfinite(int row) {
    ImpactLog log = world.impacts();
    return log.kind(row) == ObstacleKind.CIRCLE
        && (isInfinite(log.circle(row)) || isInfinite(log.id(row)));
  }

  private boolean meetsMoving(int row) {
    ImpactLog log = world.impacts();
    return log.kind(row) != ObstacleKind.CIRCLE
        && !world.velocity(log.kind(row), log.id(row)).equals(Vec2.ZERO);
  }

  private boolean isInfinite(int id) {
    return world.mass(id) == Double.POSITIVE_INFINITY;
  }

  /** In the session's own unit of speed, so that squares stay in range. */
  private double[] energies() {
    boolean collide = world.scene().collide();
    double[] each = new double[collide ? 1 : world.idLimit(ObstacleKind.CIRCLE)];
    for (int id : world.ids(ObstacleKind.CIRCLE)) {
      double vx = world.vx(id) / unit;
      double vy = world.vy(id) / unit;
      if (!collide || !isInfinite(id)) {
        each[collide ? 0 : id] += (collide ? world.mass(id) : 1) * (vx * vx + vy * vy);
      }
    }
    return each;
  }
}
