// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Lines that move push heaps: nobody is passed over or jammed while there is room, and who is
 * jammed falls when it is free again. {@code -Dcarom.contacts=1} plays two hundred balls, too.
 */
class ContactMoversTest {

  private static SceneBuilder falling() {
    return Scene.builder().gravity(0, -0.05);
  }

  /** Rows of balls of radius 10 between two walls, from the bottom up. */
  private static void pile(
      SceneBuilder scene, double left, double right, double bottom, int balls, double e) {
    Random random = new Random(balls);
    int across = (int) ((right - left - 22) / 22);
    double first = (left + right - (across - 1) * 22) / 2;
    for (int i = 0; i < balls; i++) {
      double x = first + i % across * 22 + 1.8 * random.nextDouble() - 0.9;
      double y = bottom + i / across * 23 + 1.8 * random.nextDouble() - 0.9;
      scene.circle(x, y, 10, random.nextDouble() - 0.5, 0).restitution(Math.sqrt(e));
    }
  }

  private static double root(double e) {
    return e > 0 ? Math.sqrt(e) : 1;
  }

  private static ContactRun run(SceneBuilder scene) {
    return new ContactRun(new World(scene.build())).withMovers();
  }

  private static void assertPushed(ContactRun run) {
    assertThat(run.faults()).isEmpty();
    assertThat(run.jammed).as("jammed").isEmpty();
  }

  private static void assertAbove(ContactRun run, int line) {
    double floor = run.world.line(line).ay();
    for (int i = 0; i < run.world.count(Kind.CIRCLE); i++) {
      assertThat(run.world.y(i)).as("ball %s", i).isGreaterThan(floor);
    }
  }

  /** Plays a second at each speed. */
  private static void lift(int balls, double e, int seconds, IntToDoubleFunction speed) {
    SceneBuilder scene = falling().bounds(0, -400, 150, 1_200).restitution(root(e));
    scene.line(0, 100, 150, 100).restitution(root(e));
    pile(scene, 0, 150, 140, balls, e);
    ContactRun run = run(scene);
    for (int k = 0; k < seconds; k++) {
      run.world.setVelocity(Kind.LINE, 0, 0, speed.applyAsDouble(k));
      run.play(60 * (k + 1));
      assertPushed(run);
    }
    assertAbove(run, 0);
  }

  @ParameterizedTest
  @CsvSource({"5, 0", "5, 0.5", "20, 0", "20, 0.3", "20, 0.5", "20, 0.9"})
  void aLiftGoesUpStopsAndGoesDown(int balls, double e) {
    double[] speeds = {0, 1, 0, -1, 0};
    lift(balls, e, 20, k -> speeds[k / 4]);
  }

  @ParameterizedTest
  @CsvSource({"5, 0", "20, 0", "20, 0.5"})
  void aLiftIsReversedEachSecond(int balls, double e) {
    lift(balls, e, 12, k -> k % 2 == 0 ? 1 : -1);
  }

  /** To the sides, up, down, at up to 6 a frame, and stopped. */
  @ParameterizedTest
  @CsvSource({"20, 0", "20, 0.5", "5, 0.9"})
  void aClosedBoxMoves(int balls, double e) {
    SceneBuilder scene = falling();
    double[][] lines = {{0, 0, 127, 0}, {0, 140, 127, 140}, {0, 0, 0, 140}, {127, 0, 127, 140}};
    for (double[] l : lines) {
      scene.line(l[0], l[1], l[2], l[3]).restitution(root(e));
    }
    pile(scene, 0, 127, 20, balls, e);
    ContactRun run = run(scene);
    double[][] moves = {
      {0, 0}, {0.5, 0}, {1, 0}, {3, 0}, {0, 0}, {2, 0.2}, {-1, -0.2}, {0.3, 0}, {6, 0}, {-6, 0}
    };
    for (int k = 0; k < moves.length; k++) {
      for (int line = 0; line < 4; line++) {
        run.world.setVelocity(Kind.LINE, line, moves[k][0], moves[k][1]);
      }
      run.play(100 * (k + 1));
      assertPushed(run);
    }
    for (int i = 0; i < balls; i++) {
      assertThat(run.world.x(i)).isBetween(run.world.line(2).ax(), run.world.line(3).ax());
      assertThat(run.world.y(i)).isBetween(run.world.line(0).ay(), run.world.line(1).ay());
    }
  }

  private static void piston(int balls, double w, double h, double speed, double e) {
    SceneBuilder scene = falling().bounds(0, 0, w, h).restitution(root(e));
    scene.line(w - 1, -1, w - 1, h + 1).restitution(root(e));
    pile(scene, 0, w - 1, 20, balls, e);
    ContactRun run = run(scene).play(300);
    double full = balls * Math.PI * 100 / (0.65 * h); // where 65 % of the room is filled
    double way = (w - 1 - full) / speed;
    for (double v : new double[] {-speed, 0, speed}) {
      run.world.setVelocity(Kind.LINE, 0, v, 0);
      run.play(run.world.now() + (v == 0 ? 100 : way));
      assertPushed(run);
      for (int i = 0; i < balls; i++) {
        assertThat(run.world.x(i)).as("ball %s", i).isLessThan(run.world.line(0).ax());
      }
    }
  }

  /** It fills the room in front of it to 65 %, stops and goes back. */
  @ParameterizedTest
  @CsvSource({"20, 1, 0", "20, 1, 0.5", "20, 1, 1", "20, 0.2, 0", "20, 0.2, 0.5"})
  void aPistonPushesTwentyBalls(int balls, double speed, double e) {
    piston(balls, 190, 120, speed, e);
  }

  @ParameterizedTest
  @CsvSource({"50, 1, 0.5", "50, 1, 0", "50, 1, 1", "50, 0.2, 0.5", "100, 0.2, 0.5", "100, 1, 0.5"})
  @Tag("long")
  void aPistonPushesManyBalls(int balls, double speed, double e) {
    double size = Math.sqrt(balls / 50.0);
    piston(balls, 300 * size, 200 * size, speed, e);
  }

  @ParameterizedTest
  @CsvSource({"1, 0", "1, 0.5", "1, 1", "0.2, 0", "0.2, 0.5"})
  @EnabledIfSystemProperty(named = "carom.contacts", matches = "[1-9].*")
  void aPistonPushesTwoHundredBalls(double speed, double e) {
    piston(200, 600, 400, speed, e);
  }

  /** Balls that lie exactly straight on a floor have room above: the row buckles. */
  @ParameterizedTest
  @CsvSource({"2, 0", "5, 0", "5, 0.5", "12, 0"})
  void aPistonBucklesARow(int balls, double e) {
    double w = 21.5 * balls + 30;
    SceneBuilder scene = falling().bounds(0, 0, w, 200).restitution(root(e));
    scene.line(w - 1, -1, w - 1, 201).restitution(root(e));
    for (int i = 0; i < balls; i++) {
      scene.circle(11 + 21.5 * i, 10, 10, 0, 0).restitution(Math.sqrt(e));
    }
    ContactRun run = run(scene).play(20);
    double way = w - 1 - 16 * balls - 8;
    for (double v : new double[] {-0.5, 0, 0.5}) {
      run.world.setVelocity(Kind.LINE, 0, v, 0);
      run.play(run.world.now() + (v == 0 ? 100 : 2 * way));
      assertPushed(run);
    }
  }

  /** Two lines that lean outwards close to 20 at the floor, and open again. */
  @ParameterizedTest
  @CsvSource({"1, 0", "1, 0.5", "3, 0", "3, 0.5", "20, 0", "20, 0.5"})
  void aWedgeCloses(int balls, double e) {
    SceneBuilder scene = falling();
    double[][] lines = {
      {0, 0, 400, 0},
      {110, 1, 60, 241},
      {60, 241, 60, 700},
      {290, 1, 340, 241},
      {340, 241, 340, 700}
    };
    for (double[] l : lines) {
      scene.line(l[0], l[1], l[2], l[3]).restitution(root(e));
    }
    pile(scene, 120, 280, 31, balls, e);
    ContactRun run = run(scene).play(100);
    for (double v : new double[] {0.5, 0, -0.5, 0}) {
      for (int line = 1; line < 5; line++) {
        run.world.setVelocity(Kind.LINE, line, line < 3 ? v : -v, 0);
      }
      run.play(run.world.now() + 158);
      assertPushed(run);
      for (int i = 0; i < balls; i++) {
        assertThat(run.world.x(i)).isBetween(60.0, 340.0);
        assertThat(run.world.y(i)).isPositive();
      }
    }
  }

  /**
   * Jaws close to less than a diameter: the ball between them is jammed, and the log says so. When
   * they open it falls, and lies on the floor.
   */
  @ParameterizedTest
  @CsvSource({"0, 10", "0.5, 10", "0.5, 100"})
  void aCrushedBallIsReportedAndFallsWhenItIsFree(double e, double height) {
    SceneBuilder scene = falling().line(0, 0, 400, 0).restitution(root(e));
    scene.line(150, 0, 150, 600).line(250, 0, 250, 600);
    scene.line(180, height - 10, 220, height - 10).restitution(root(e));
    ContactRun run = run(scene.circle(200, height, 10, 0, 0).restitution(Math.sqrt(e)));
    close(run, 0.5, 90);
    assertThat(run.faults()).isEmpty();
    assertThat(run.jammed).containsExactly(0);
    assertThat(run.world.isResting(0)).isTrue();
    run.world.remove(Kind.LINE, 3);
    close(run, 0, 20);
    assertThat(run.world.y(0)).as("held by the jaws").isEqualTo(height);
    close(run, -0.5, 200);
    assertThat(run.isFinished()).isTrue();
    assertThat(run.world.y(0)).isBetween(10 - 1e-9, 10.5);
    assertThat(run.world.isResting(0)).isTrue();
  }

  private static void close(ContactRun run, double speed, double time) {
    run.world.setVelocity(Kind.LINE, 1, speed, 0);
    run.world.setVelocity(Kind.LINE, 2, -speed, 0);
    run.play(run.world.now() + time);
  }

  /** Short lines that go back and forth among balls; who is jammed may be passed over. */
  @ParameterizedTest
  @CsvSource({"1, 0", "2, 0.5", "3, 0.5", "4, 0.9"})
  void paddles(int seed, double e) {
    SceneBuilder scene = falling().bounds(0, 0, 340, 330).restitution(root(e));
    Random random = new Random(seed);
    double[][] speeds = new double[9][2];
    for (int k = 0; k < 9; k++) {
      double x = 85 + 85 * (k % 3);
      double y = 75 + 90 * (k / 3);
      double a = 2 * Math.PI * random.nextDouble();
      double b = 2 * Math.PI * random.nextDouble();
      double speed = 0.3 + 0.7 * random.nextDouble();
      speeds[k] = new double[] {speed * Math.cos(b), speed * Math.sin(b)};
      double dx = 15 * Math.cos(a);
      double dy = 15 * Math.sin(a);
      scene.line(x - dx, y - dy, x + dx, y + dy).restitution(root(e));
    }
    for (int i = 0; i < 14; i++) {
      scene.circle(20 + 22 * i, 20, 10, 0, 0).restitution(Math.sqrt(e));
      scene.circle(24 + 21 * i, 310, 10, 0, 0).restitution(Math.sqrt(e));
    }
    ContactRun run = run(scene);
    for (int k = 0; k < 20; k++) {
      for (int line = 0; line < 9; line++) {
        int sign = k % 2 == 0 ? 1 : -1;
        run.world.setVelocity(Kind.LINE, line, sign * speeds[line][0], sign * speeds[line][1]);
      }
      run.play(30 * (k + 1));
    }
    assertThat(run.faults()).isEmpty();
    assertThat(run.jammed.size()).as("jammed: %s", run.jammed).isLessThan(3);
  }
}
