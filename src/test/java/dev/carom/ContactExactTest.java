// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Motions with contacts under gravity of which a formula, or a plain sum, tells the right end. */
class ContactExactTest {

  /** Off what is round, as a part of the path: the error of the clock of contacts. */
  private static final double ROUND = 2e-3;

  private static final double G = 0.05;

  private static SceneBuilder falling() {
    return Scene.builder().gravity(0, -G);
  }

  /**
   * Both come to the floor with v = sqrt(2 g h); the lower one, three times as heavy, turns round,
   * and the upper one leaves with 2 v: it rises to 4 h. Elastic impacts go on for ever.
   */
  @Test
  void aSuperball() {
    SceneBuilder scene = falling().line(-500, 0, 500, 0).circle(0, 110, 10, 0, 0).mass(3);
    ContactRun run = new ContactRun(new World(scene.circle(0, 130 + 1e-9, 10, 0, 0).build()));
    double energy = run.energy();
    double top = 0;
    while (run.world.now() < 250) {
      run.play(run.world.now() + 0.5);
      top = Math.max(top, run.world.y(1));
    }
    assertThat(top).isCloseTo(30 + 400, within(0.01));
    run.play(5_000);
    assertThat(run.faults()).isEmpty();
    assertThat(run.energy()).isCloseTo(energy, within(1e-12 * energy));
    assertThat(run.resting()).isZero();
  }

  /** So many as come from one side leave on the other; the rest stand still. */
  @ParameterizedTest
  @CsvSource({"5, 1", "5, 2", "10, 1", "10, 3", "3, 2"})
  void aCradleOnTheFloor(int standing, int coming) {
    World world = new World(row(falling(), standing, coming, 1, 0).build());
    world.advanceTo(150);
    for (int i = 0; i < standing + coming; i++) {
      double right = i >= standing ? 1 : 0;
      assertThat(world.vx(i)).as("ball %d", i).isCloseTo(right, within(1e-12));
      assertThat(world.vy(i)).isZero();
    }
  }

  /** A row of balls on y = 0, with gaps; from its left others come, with velocity 1. */
  private static SceneBuilder row(
      SceneBuilder scene, int standing, int coming, double e, double gap) {
    scene.line(-5_000, 0, 5_000, 0);
    for (int i = 0; i < standing + coming; i++) {
      boolean comes = i < coming;
      double x = (20 + gap) * i - (comes ? 40 : 0);
      scene.circle(x, 10, 10, comes ? 1 : 0, 0).restitution(Math.sqrt(e));
    }
    return scene;
  }

  /**
   * Level ground presses nothing together: a row on it collides as without gravity, with gaps, and
   * where the balls touch. All momenta are the same; where a row without gravity gets stuck, at the
   * end, to a part of what gravity adds in a tick of the contacts, which is 0.05.
   */
  @ParameterizedTest
  @CsvSource({
    "5, 1, 0.5, 0.1",
    "5, 1, 0.9, 0.1",
    "10, 1, 0.5, 0.01",
    "10, 2, 0, 0.1",
    "5, 1, 0.9, 0",
    "5, 1, 0.5, 0",
    "10, 1, 0.5, 0",
    "10, 1, 0.9, 0"
  })
  void aRowOnLevelGroundCollidesAsWithoutGravity(int standing, int coming, double e, double gap) {
    World falling = new World(row(falling(), standing, coming, e, gap).build());
    SceneBuilder weightless = Scene.builder();
    ContactRun right = new ContactRun(new World(row(weightless, standing, coming, e, gap).build()));
    for (int t = 50; t <= 800; t += 150) {
      falling.advanceTo(t);
      right.play(t, t);
      boolean stuck = !right.jammed.isEmpty();
      for (int i = 0; i < standing + coming && (!stuck || t == 800); i++) {
        String name = "ball " + i + " at " + t;
        double error = stuck ? 4e-3 * G : 1e-9;
        assertThat(falling.vx(i)).as(name).isCloseTo(right.world.vx(i), within(error));
        assertThat(falling.y(i)).as(name).isCloseTo(10, within(stuck ? 10 * 0x1p-7 : 0));
      }
    }
  }

  /**
   * Two balls hit three that touch. Without gravity all five get stuck, and go on with 0.4. On the
   * ground they part again, with differences of up to 2 % of what gravity adds in a tick.
   */
  @Test
  void aTouchingRowThatTwoHitPartsABit() {
    World world = new World(row(falling(), 3, 2, 0.3, 0).build());
    world.advanceTo(800);
    double sum = 0;
    for (int i = 0; i < 5; i++) {
      sum += world.vx(i);
      assertThat(world.vx(i)).as("ball " + i).isCloseTo(0.4, within(0.025 * G));
    }
    assertThat(sum).isCloseTo(2, within(1e-9));
  }

  /** A ball that slides into a wall leaves it with e times its speed. */
  @ParameterizedTest
  @CsvSource({"1e-6, 0.5", "1e-3, 0.9", "0.1, 0.3", "2, 0.5", "0.1, 0"})
  void aSliderLeavesAWall(double speed, double e) {
    SceneBuilder scene = falling().line(0, 0, 1000, 0).line(0, 0, 0, 50);
    World world = new World(scene.circle(11, 10, 10, -speed, 0).restitution(e).build());
    world.advanceTo(2 / speed);
    assertThat(world.vx(0)).isCloseTo(e * speed, within(1e-15));
    assertThat(world.x(0)).isCloseTo(10 + e, within(1e-9));
    assertThat(world.y(0)).isEqualTo(10);
  }

  /**
   * Placed on a peg at rest it rolls off, and 40 frames after it left it is where {@link
   * PlainRolling} says.
   */
  @ParameterizedTest
  @CsvSource({"0.02, 0", "0.1, 0.5", "0.3, 0", "0.6, 0", "0.6, 0.9"})
  void aBallRollsOffAPeg(double theta, double e) {
    double x = 20 * Math.sin(theta);
    double y = 20 * Math.cos(theta);
    double time = 40 + Math.sqrt(20 / G) * (2.1 - Math.log(theta)); // at 40 or more it is off
    PlainRolling.Place right = PlainRolling.after(20, theta, 0, G, time);
    for (boolean collide : new boolean[] {false, true}) {
      SceneBuilder scene = falling().collide(collide).peg(0, 0, 10);
      World world = new World(scene.circle(x, y + 1e-9, 10, 0, 0).restitution(e).build());
      world.advanceTo(time);
      double error = Math.hypot(world.x(0) - right.x(), world.y(0) - right.y());
      assertThat(error / right.path()).isLessThan(ROUND);
    }
  }

  /**
   * The error is of second order in the clock of contacts, whose tick depends on the ball: on a peg
   * of sixteen times the size, where all takes four times as long, it is a sixteenth of the path.
   * Of first order would be a quarter.
   */
  @Test
  void theErrorIsOfSecondOrder() {
    assertThat(meanError(20)).isLessThan(ROUND);
    assertThat(meanError(320)).isLessThan(ROUND / 8);
  }

  /** As a part of the path, over some places on a peg. */
  private static double meanError(double rho) {
    double sum = 0;
    for (int k = 0; k < 10; k++) {
      double theta = 0.15 + 0.05 * k;
      SceneBuilder scene = falling().peg(0, 0, rho - 10);
      scene.circle(rho * Math.sin(theta), rho * Math.cos(theta) + 1e-9, 10, 0, 0).restitution(0);
      World world = new World(scene.build());
      double time = Math.sqrt(rho / G) * (4.1 - Math.log(theta));
      PlainRolling.Place right = PlainRolling.after(rho, theta, 0, G, time);
      world.advanceTo(time);
      sum += Math.hypot(world.x(0) - right.x(), world.y(0) - right.y()) / right.path();
    }
    return sum / 10;
  }

  /**
   * At joints it keeps what its velocity has along the next side; beyond the middle it returns. It
   * changes sides exactly.
   */
  @ParameterizedTest
  @CsvSource({"8, 1", "12, 1", "40, 1", "40, 0.2"})
  void aBallSlidesInAHalfPipe(int sides, double size) {
    double radius = 200 * size;
    double r = 10 * size;
    SceneBuilder scene = falling();
    double[] xs = new double[sides + 1];
    double[] ys = new double[sides + 1];
    double inner = radius - r / Math.cos(Math.PI / 2 / sides);
    for (int i = 0; i <= sides; i++) {
      double a = Math.PI * i / sides;
      double b = Math.PI * (i + 1) / sides;
      xs[i] = -inner * Math.cos(a);
      ys[i] = -inner * Math.sin(a);
      if (i < sides) {
        double by = -radius * Math.sin(b);
        scene.line(-radius * Math.cos(a), -radius * Math.sin(a), -radius * Math.cos(b), by);
      }
    }
    int start = sides / 8;
    double x = (xs[start] + xs[start + 1]) / 2;
    double y = (ys[start] + ys[start + 1]) / 2;
    World world = new World(scene.circle(x, y + 1e-9, r, 0, 0).restitution(0).build());
    PlainSliding right = new PlainSliding(xs, ys, G);
    right.start(start, 0.5);
    double step = 10 * Math.sqrt(size);
    for (int k = 1; k <= 30; k++) {
      right.advance(step);
      world.advanceTo(k * step);
      double error = Math.hypot(world.x(0) - right.x(), world.y(0) - right.y());
      String name = "at " + k * step + ", path " + right.path;
      assertThat(error).as(name).isLessThan(1e-9 * (1 + right.path));
    }
  }

  /**
   * Balls in a shaft press two others apart, with all their weight: those move as {@link
   * PlainWedge} says, to a hundredth of their path. Of twenty the last one is felt late: a tenth.
   */
  @ParameterizedTest
  @CsvSource({"1, 1, 0.01", "1, 5, 0.01", "1, 20, 0.01", "5, 1, 0.01", "20, 1, 0.1"})
  void aColumnPressesWithAllItsWeight(int balls, double mass, double error) {
    double theta = 0.62;
    SceneBuilder scene = falling().line(-500, 0, 500, 0);
    scene.line(-10.01, 22, -10.01, 22 + 25 * balls).line(10.01, 22, 10.01, 22 + 25 * balls);
    scene.circle(-20 * Math.sin(theta), 10, 10, 0, 0).restitution(0);
    scene.circle(20 * Math.sin(theta), 10, 10, 0, 0).restitution(0);
    for (int i = 0; i < balls; i++) {
      double y = 10 + 20 * Math.cos(theta) + 20 * i + 1e-9;
      scene.circle(0, y, 10, 0, 0).mass(mass).restitution(0);
    }
    World world = new World(scene.build());
    for (double t : new double[] {10, 15, 20}) {
      double[] right = PlainWedge.after(20, theta, balls * mass, 1, G, t);
      double path = right[0] - 20 * Math.sin(theta);
      world.advanceTo(t);
      for (int side = 0; side < 2; side++) {
        double x = Math.abs(world.x(side));
        assertThat(x).as("at %s", t).isCloseTo(right[0], within(ROUND * 20 + error * path));
      }
    }
  }
}
