// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Outcome;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.Arrays;

/**
 * Energy over one step: of each circle, or of all finite masses together if they collide. With
 * gravity it is that of motion and height together. It grows only if a row bounced with a
 * restitution above 1, or met an infinite mass or a moving obstacle. It is lost only if a row has a
 * restitution below 1 or another outcome than a bounce, or met one of those. Under gravity circles
 * in contact lose energy without a row, and the velocities shown lag: so there energy may be lost,
 * and rise a little.
 *
 * <p>Nothing is demanded where there is gravity and something moves: it may carry circles up and
 * down, without a row.
 */
final class EnergyCheck {

  /** Relative, of an impact. */
  private static final double ROUNDING = 0x1p-48;

  /** In m g R a circle: how far the energy may rise under gravity. */
  private static final double RISE = 0.1;

  /** So many impacts at one place bring circles in contact. */
  private static final int MANY = 24;

  private final World world;
  private final double unit;
  private Energies before = new Energies(0);

  /**
   * Whether circles may be in contact: something settled or jammed, or many impacts came at once.
   */
  private boolean mayTouch;

  /**
   * Energies, and what their rounding is in proportion to: twice that of motion, and of the height
   * above or below 0.
   */
  private static final class Energies {
    private final double[] each;
    private final double[] scales;

    Energies(int count) {
      each = new double[count];
      scales = new double[count];
    }
  }

  EnergyCheck(World world, double speedUnit) {
    this.world = world;
    unit = speedUnit;
  }

  /** The same check of another world of the same state. */
  EnergyCheck of(World same) {
    EnergyCheck check = new EnergyCheck(same, unit);
    check.mayTouch = mayTouch;
    return check;
  }

  /** Notes the state at the start of a step. */
  void begin() {
    before = energies();
  }

  /** Compares the state at the end of the step. */
  void end() throws FindingException {
    if (isCarried()) {
      return;
    }
    int rows = world.impacts().size();
    Energies after = energies();
    int count = after.each.length;
    boolean[] mayGain = new boolean[count];
    boolean[] mayLose = new boolean[count];
    mayTouch |= rows >= MANY;
    for (int row = 0; row < rows; row++) {
      Outcome outcome = world.impacts().outcome(row);
      mayTouch |= outcome == Outcome.SETTLED || outcome == Outcome.JAMMED || restitution(row) == 0;
      int i = world.scene().collide() ? 0 : world.impacts().circle(row);
      mayGain[i] |= mayGain(row);
      mayLose[i] |= mayLose(row);
    }
    double[] rises = rises(count);
    for (int i = 0; i < count; i++) {
      double scale = falls() ? Math.max(before.scales[i], after.scales[i]) : before.scales[i];
      double slack = ROUNDING * (rows + 4) * scale;
      boolean gained = after.each[i] > before.each[i] + slack + rises[i] && !mayGain[i];
      boolean lost = after.each[i] < before.each[i] - slack && !mayLose[i] && !falls();
      if (gained || lost) {
        throw new FindingException(
            "energy %s went from %s to %s in %d impacts"
                .formatted(
                    world.scene().collide() ? "of all" : "of circle " + i,
                    before.each[i],
                    after.each[i],
                    rows));
      }
    }
  }

  private boolean falls() {
    return !world.gravity().equals(Vec2.ZERO);
  }

  private boolean mayTouch() {
    return falls() && mayTouch;
  }

  private boolean isCarried() {
    return falls() && (moves(Kind.LINE) || moves(Kind.PEG) || infiniteMassesMove());
  }

  private boolean infiniteMassesMove() {
    return Arrays.stream(world.ids(Kind.CIRCLE))
        .anyMatch(id -> isInfinite(id) && (world.vx(id) != 0 || world.vy(id) != 0));
  }

  private boolean moves(Kind kind) {
    return Arrays.stream(world.ids(kind))
        .anyMatch(id -> !world.velocity(kind, id).equals(Vec2.ZERO));
  }

  /** Twice the energy by which each may rise, or all together. */
  private double[] rises(int count) {
    double[] rises = new double[count];
    if (!mayTouch()) {
      return rises;
    }
    boolean collide = world.scene().collide();
    for (int id : world.ids(Kind.CIRCLE)) {
      double mass = collide ? world.traits(Kind.CIRCLE, id).mass() : 1;
      if (mass < Double.POSITIVE_INFINITY) {
        double g = world.gravity().length() / unit;
        rises[collide ? 0 : id] += 2 * RISE * mass * g * world.radius(id) / unit;
      }
    }
    return rises;
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
    return world.traits(Kind.CIRCLE, log.circle(row)).restitution()
        * world.traits(log.kind(row), log.id(row)).restitution();
  }

  /** Whether one of two circles has infinite mass, which gives or takes any energy. */
  private boolean meetsInfinite(int row) {
    ImpactLog log = world.impacts();
    return log.kind(row) == Kind.CIRCLE && (isInfinite(log.circle(row)) || isInfinite(log.id(row)));
  }

  private boolean meetsMoving(int row) {
    ImpactLog log = world.impacts();
    return log.kind(row) != Kind.CIRCLE
        && !world.velocity(log.kind(row), log.id(row)).equals(Vec2.ZERO);
  }

  private boolean isInfinite(int id) {
    return world.traits(Kind.CIRCLE, id).mass() == Double.POSITIVE_INFINITY;
  }

  /** In the session's own unit of speed, so that squares stay in range; twice the usual ones. */
  private Energies energies() {
    boolean collide = world.scene().collide();
    Energies energies = new Energies(collide ? 1 : world.idLimit(Kind.CIRCLE));
    for (int id : world.ids(Kind.CIRCLE)) {
      if (!collide || !isInfinite(id)) {
        int i = collide ? 0 : id;
        double mass = collide ? world.traits(Kind.CIRCLE, id).mass() : 1;
        double vx = world.vx(id) / unit;
        double vy = world.vy(id) / unit;
        double motion = vx * vx + vy * vy;
        double x = height(world.gravity().x(), world.x(id), id);
        double y = height(world.gravity().y(), world.y(id), id);
        energies.each[i] += mass * (motion - 2 * (x + y));
        energies.scales[i] += mass * (motion + 2 * (Math.abs(x) + Math.abs(y)));
      }
    }
    return energies;
  }

  /** The potential energy along one axis, turned; none of what does not fall. */
  private double height(double gravity, double place, int id) {
    return gravity == 0 || isInfinite(id) ? 0 : gravity / unit * place / unit;
  }
}
