// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * What an {@link Uncertainty} says after edits of the obstacles between two steps. A circle with a
 * wide error flies on freely. Beside its path, further off than the radius but by less than the
 * error, there is something or not: only the obstacles as they are now count.
 */
class UncertaintyEditsTest {

  private static final double RADIUS = 2;

  /** For how long nothing is in the way. */
  private static final double FREE = 4;

  private static final int CIRCLES = 40;

  private World world;
  private Uncertainty uncertainty;
  private int id;

  // The middle of the way ahead, and the direction to the left of it.
  private double x;
  private double y;
  private double leftX;
  private double leftY;
  private double error;

  /** Plays until the error is wide, and the side casts were asked, at the start of a free way. */
  @BeforeEach
  void play() {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, 200, 200);
    for (int i = 0; i < 16; i++) {
      builder.peg(25 + 50 * (i % 4) + 2 * (i / 4), 25 + 50 * (i / 4), 6);
    }
    for (int i = 0; i < CIRCLES; i++) {
      builder.circle(50, 50, RADIUS, 5 * Math.cos(i), 5 * Math.sin(i));
    }
    world = new World(builder.build());
    uncertainty = world.uncertainty(1);
    while (!isFound()) {
      assertThat(world.now()).isLessThan(200);
      world.step(0.5);
    }
    double vx = world.vx(id);
    double vy = world.vy(id);
    double speed = Math.hypot(vx, vy);
    x = world.x(id) + FREE / 2 * vx;
    y = world.y(id) + FREE / 2 * vy;
    leftX = -vy / speed;
    leftY = vx / speed;
    error = uncertainty.bound(id) / 2; // of it, that across is more than half
  }

  /** Whether there is such a circle now. */
  private boolean isFound() {
    for (id = 0; id < CIRCLES; id++) {
      double bound = uncertainty.bound(id);
      boolean isWide = bound > 0x1p-9 * RADIUS && bound < 0x1p-3 * RADIUS;
      if (isWide && world.cast(new SweptCircle(circle(), velocity()), 2 * FREE).isEmpty()) {
        return true;
      }
    }
    return false;
  }

  private Circle circle() {
    return new Circle(world.x(id), world.y(id), RADIUS);
  }

  private Vec2 velocity() {
    return new Vec2(world.vx(id), world.vy(id));
  }

  /** The bound when the circle is past the middle of the way, where nothing was hit. */
  private double boundBehind() {
    world.step(FREE);
    ImpactLog log = world.impacts();
    for (int row = 0; row < log.size(); row++) {
      assertThat(log.circle(row)).isNotEqualTo(id);
    }
    return uncertainty.bound(id);
  }

  private double besideX(double distance) {
    return x + distance * leftX;
  }

  private double besideY(double distance) {
    return y + distance * leftY;
  }

  /** A peg that a circle on the way misses by half of its error. */
  private int addPegBeside() {
    double distance = 1 + RADIUS + error / 2;
    return world.addPeg(besideX(distance), besideY(distance), 1, Traits.DEFAULT);
  }

  /** A line across that ends as near. */
  private int addLineBeside() {
    double near = RADIUS + error / 2;
    return world.addLine(
        besideX(near), besideY(near), besideX(near + 1), besideY(near + 1), Traits.DEFAULT);
  }

  @Test
  void nothingBesideIsNothingToHit() {
    assertThat(boundBehind()).isFinite();
  }

  @Test
  void anAddedPegMayBeHit() {
    addPegBeside();
    assertThat(boundBehind()).isInfinite();
  }

  @Test
  void anAddedLineMayBeHit() {
    addLineBeside();
    assertThat(boundBehind()).isInfinite();
  }

  @Test
  void whatWasAddedAndTakenAwayIsNotHit() {
    int peg = addPegBeside();
    int line = addLineBeside();
    assertThat(uncertainty.bound(id)).isFinite();
    world.remove(Kind.PEG, peg);
    world.remove(Kind.LINE, line);
    assertThat(boundBehind()).isFinite();
  }

  @Test
  void aPegOfTheSceneThatWasMovedMayBeHit() {
    double distance = 1 + RADIUS + error / 2;
    world.setShape(Kind.PEG, 0, new Circle(besideX(distance), besideY(distance), 1));
    assertThat(boundBehind()).isInfinite();
  }

  @Test
  void whatWasMovedAwayIsNotHit() {
    int peg = addPegBeside();
    assertThat(uncertainty.bound(id)).isFinite();
    world.setShape(
        Kind.PEG,
        peg,
        new Circle(besideX(1 + RADIUS + 8 * error), besideY(1 + RADIUS + 8 * error), 1));
    assertThat(boundBehind()).isFinite();
  }

  @Test
  void filtersCount() {
    int peg = addPegBeside();
    world.setTraits(Kind.PEG, peg, world.traits(Kind.PEG, peg).withFilter(new Filter(2, 2)));
    assertThat(boundBehind()).isFinite();
  }

  @Test
  void filtersOfTheCircleCount() {
    addPegBeside();
    world.setTraits(Kind.CIRCLE, id, world.traits(Kind.CIRCLE, id).withFilter(new Filter(2, 2)));
    assertThat(boundBehind()).isFinite();
  }

  @Test
  void aSensorIsNotHit() {
    int peg = addPegBeside();
    world.setTraits(Kind.PEG, peg, Traits.DEFAULT.withResponse(Response.SENSOR));
    assertThat(boundBehind()).isFinite();
  }

  @Test
  void theRadiusOfTheCircleCounts() {
    double distance = 1 + 1.25 * RADIUS + error / 2;
    world.addPeg(besideX(distance), besideY(distance), 1, Traits.DEFAULT);
    world.setShape(Kind.CIRCLE, id, new Circle(world.x(id), world.y(id), 1.25 * RADIUS));
    assertThat(boundBehind()).isInfinite();
  }

  /** Behind the circle, so the answer does not wait for a step, which would index them. */
  @Test
  void eachOfManyAddedPegsMayBeHit() {
    assertThat(boundBehind()).isFinite();
    for (int i = 0; i < 100; i++) {
      world.addPeg(300 + 3 * i, 300, 1, Traits.DEFAULT);
    }
    addPegBeside();
    assertThat(uncertainty.bound(id)).isInfinite();
  }
}
