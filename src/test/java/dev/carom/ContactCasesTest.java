// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.EverydayScenes.Shape;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Contacts under gravity that rules of least hops and heaps got wrong: each test says what is right
 * first, and what happened before.
 */
class ContactCasesTest {

  private static SceneBuilder falling(double g) {
    return Scene.builder().gravity(0, -g);
  }

  /**
   * The ball rolls over the corner and falls, as by the equation of {@link PlainRolling}; the side
   * of the table changes nothing. It stopped at the corner for ever, where the ends of the two
   * lines bounced it in turn.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void aBallRollsOverTheEdgeOfATable(double e) {
    World bare = table(false, e);
    World table = table(true, e);
    bare.advanceTo(8);
    table.advanceTo(8);
    PlainRolling.Place right = PlainRolling.after(1, 0, 1.5, 10, 8 - 10 / 1.5);
    for (World world : new World[] {bare, table}) {
      double error = Math.hypot(world.x(0) - right.x(), world.y(0) - right.y());
      assertThat(error).isLessThan(2e-3 * (10 + right.path()));
    }
    assertThat(table.x(0)).isCloseTo(bare.x(0), within(1e-9));
    assertThat(table.y(0)).isCloseTo(bare.y(0), within(1e-9));
  }

  private static World table(boolean hasSide, double e) {
    SceneBuilder scene = falling(10).line(-50, 0, 0, 0);
    if (hasSide) {
      scene.line(0, 0, 0, -40);
    }
    return new World(scene.circle(-10, 1, 1, 1.5, 0).restitution(e).build());
  }

  /**
   * Level ground does not press sliders together: they leave with e times their speed, at any
   * speed. With gravity 500 they left at 1.105, whatever they came with.
   */
  @ParameterizedTest
  @CsvSource({
    "1e-6, 0",
    "1e-6, 0.5",
    "1e-6, 0.9",
    "0.01, 0",
    "0.01, 0.5",
    "0.01, 0.9",
    "1, 0.5",
    "3, 0.5"
  })
  void twoSlidersLeaveEachOther(double speed, double e) {
    SceneBuilder scene = falling(500).line(-1000, 0, 1000, 0);
    scene.circle(-10.005, 10, 10, speed, 0).restitution(e);
    World world = new World(scene.circle(10.005, 10, 10, -speed, 0).build());
    world.advanceTo(0.04 / speed);
    assertThat(world.vx(0)).isCloseTo(-e * speed, within(1e-14 * speed));
    assertThat(world.vx(1)).isCloseTo(e * speed, within(1e-14 * speed));
    assertThat(world.vy(0)).isZero();
    assertThat(world.y(1)).isEqualTo(10);
  }

  /**
   * The second line goes on where the first ends, to the last place: the ball slides on as on one
   * line. It took 2,000,000 rows a call, and the clock stood at 0.037.
   */
  @Test
  void aBallSlidesOverTheJointOfATrack() {
    double[] a = {74.22243932794913, -63.992417521210356};
    double[] b = {77.25192664745727, -66.60435293023934};
    double[] c = {80.28141396696539, -69.21628833926835};
    World one = track(falling(9.8).line(a[0], a[1], c[0], c[1]));
    World two = track(falling(9.8).line(a[0], a[1], b[0], b[1]).line(b[0], b[1], c[0], c[1]));
    for (double t : new double[] {0.03, 0.05, 0.08}) {
      one.advanceTo(t);
      two.advanceTo(t);
      assertThat(two.x(0)).isCloseTo(one.x(0), within(1e-9));
      assertThat(two.y(0)).isCloseTo(one.y(0), within(1e-9));
      assertThat(two.vx(0)).isCloseTo(one.vx(0), within(1e-9));
    }
  }

  private static World track(SceneBuilder scene) {
    scene.circle(76.92032712087438, -64.9981020924279, 1, 26.50801404569612, -22.854434829003697);
    return new World(scene.restitution(0).build());
  }

  /**
   * A ball that rests over a joint of two lines and gets a velocity is 20 further on after 10. It
   * stayed there.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5})
  void aBallOverAJointSlidesOff(double e) {
    SceneBuilder scene = falling(500).line(-100, 0, 0, 0).line(0, 0, 100, 0);
    World world = new World(scene.circle(0, 10, 10, 0, 0).restitution(e).build());
    world.advanceTo(1);
    assertThat(world.isResting(0)).isTrue();
    world.setVelocity(0, 2, 0);
    world.advanceTo(11);
    assertThat(world.x(0)).isCloseTo(20, within(1e-9));
    assertThat(world.y(0)).isCloseTo(10, within(1e-9));
  }

  /**
   * A heavy ball falls on a light one in a narrow box: some tens of events, then the light one is
   * pushed aside. A million to one took 5.6 million rows and 34 unfinished calls.
   */
  @ParameterizedTest
  @CsvSource({"100, 0", "1e4, 0.5", "1e6, 0", "1e6, 0.5", "1e6, 0.9"})
  void aHeavyBallFallsOnALightOne(double mass, double e) {
    double root = Math.sqrt(e);
    SceneBuilder scene = falling(0.05).bounds(0, 0, 100, 400).restitution(e > 0 ? root : 1);
    scene.circle(50, 10, 10, 0, 0).restitution(root);
    scene.circle(50.5, 100, 10, 0, 0).mass(mass).restitution(root);
    ContactRun run = new ContactRun(new World(scene.build())).play(2_000);
    assertThat(run.faults()).isEmpty();
    assertThat(run.rows).isLessThan(1_000);
  }

  /**
   * Eight disks on a floor that goes up and down between walls, where five have just room side by
   * side: none overlaps another. One walked through another one, their centres 0.003 apart.
   */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void disksOnAFloorThatShakesDoNotOverlap(long seed) {
    double width = 5 + 1e-7;
    SceneBuilder scene = falling(10).line(-1, 0, 6, 0);
    scene.line(0, -5, 0, 40).line(width, -5, width, 40);
    Random random = new Random(seed);
    for (int i = 0; i < 8; i++) {
      double x = 0.55 + 1.2 * (i % 4) + 0.2 * random.nextDouble();
      int row = i / 4;
      scene.circle(x, 0.6 + 1.1 * row, 0.5, 0, 0).restitution(0.7);
    }
    ContactRun run = new ContactRun(new World(scene.build())).withMovers();
    for (int k = 0; k < 100; k++) {
      run.world.setVelocity(Kind.LINE, 0, 0, k % 2 == 0 ? 0.25 : -0.25);
      run.play(0.1 * (k + 1), 1 / 60.0);
    }
    assertThat(run.faults()).isEmpty();
    assertThat(run.jammed).isEmpty();
  }

  /**
   * As many balls as exactly fill the floor, and more on them: all calls are finished. A frame took
   * seconds, 96 calls of 600 were unfinished.
   */
  @ParameterizedTest
  @CsvSource({"5, 12, 0", "5, 12, 0.5", "10, 34, 0.5", "20, 50, 0.5"})
  void ballsFillAFloorExactly(int across, int balls, double e) {
    SceneBuilder scene = falling(0.05).bounds(0, 0, 20 * across, 900);
    Random random = new Random(5);
    int beside = across - 1;
    double apart = (20 * across - 24.0) / (beside - 1);
    for (int i = 0; i < balls; i++) {
      double x = 11 + apart * (i % beside) + 0.8 * random.nextDouble();
      scene.circle(x, 60 + 23 * (i / beside), 10, random.nextDouble() - 0.5, 0).restitution(e);
    }
    ContactRun run = new ContactRun(new World(scene.build())).play(600);
    assertThat(run.faults()).isEmpty();
  }

  /** The same with a funnel above: 200 balls on a floor of exactly 40 diameters. */
  @Test
  @Tag("long")
  void aFunnelOverAFloorThatBallsFillExactly() {
    ContactRun run = new ContactRun(new World(funnel(800))).play(600);
    assertThat(run.faults()).isEmpty();
  }

  private static Scene funnel(double w) {
    double e = Math.sqrt(0.5);
    SceneBuilder scene = falling(0.05).bounds(0, 0, w, 900).restitution(e);
    scene.line(0, 550, w / 2 - 30, 350).restitution(e).line(w, 550, w / 2 + 30, 350);
    scene.restitution(e);
    Random random = new Random(5);
    for (int i = 0; i < 200; i++) {
      double x = w / 2 - 320 + 22 * (i % 30) + 1.8 * random.nextDouble();
      double y = 600 + 23 * (i / 30) + 1.8 * random.nextDouble();
      scene.circle(x, y, 10, random.nextDouble() - 0.5, random.nextDouble() - 0.5).restitution(e);
    }
    return scene.build();
  }

  /**
   * Far from the origin a heavy ball presses a light one into a corner: they overlap by at most 16
   * ulps of a coordinate, 2e-6. It was 6 % of a radius, without a row.
   */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void aHeavyBallPressesALightOneIntoACornerFarAway(long seed) {
    Random random = new Random(seed);
    double far = 1e9;
    double angle = 0.3 + 0.5 * random.nextDouble();
    SceneBuilder scene = falling(10);
    double dx = 10 * Math.cos(angle);
    double dy = 10 * Math.sin(angle);
    scene.line(far, far, far + dx, far + dy).line(far, far, far - dx, far + dy);
    double light = 0.02 + 0.04 * random.nextDouble();
    double heavy = 0.02 + 0.04 * random.nextDouble();
    scene.circle(far, far + light / Math.cos(angle) + 0.02, light, 0, 0).mass(0.01);
    scene.restitution(0);
    double x = far + 0.02 * (random.nextDouble() - 0.5);
    scene.circle(x, far + 4 * (light + heavy), heavy, 0, 0).mass(100).restitution(0);
    ContactRun run = new ContactRun(new World(scene.build()));
    assertThat(run.overlap).as("at the start").isLessThanOrEqualTo(1);
    run.play(4, 1 / 60.0);
    assertThat(run.isFinished()).isTrue();
    assertThat(run.overlap).isLessThanOrEqualTo(1);
  }

  /**
   * Whole coordinates, as in a first program: no call is unfinished. Of 34,059 calls 92 were, and
   * the worst frame took 2.4 s.
   */
  @ParameterizedTest
  @CsvSource({"V, 0", "BOWL, 0", "FUNNEL_2, 0.5", "PEGS, 0", "STAIRS, 0"})
  void wholeCoordinates(Shape shape, double e) {
    EverydayScenes scenes = EverydayScenes.of(shape, 30).restitution(e);
    scenes.places(EverydayScenes.Places.INTEGER);
    ContactRun run = new ContactRun(new World(scenes.scene())).play(300);
    assertThat(run.faults()).as("%s", scenes).isEmpty();
  }

  /** A one-way line without length has no left side: it is not there. */
  @Test
  void aOneWayPointHoldsNothing() {
    SceneBuilder scene = Scene.builder().gravity(0, -1).line(-90, 0, 90, 0).line(5, 0.5, 5, 0.5);
    scene.oneWay().circle(4.9, 1, 1, 0, 0).restitution(0).collide(true);
    World world = new World(scene.circle(6.2, 2.5, 1, 0, 0).restitution(0).build());
    world.advanceTo(40);
    assertThat(world.y(0)).isCloseTo(1, within(0x1p-7));
    assertThat(world.y(1)).isCloseTo(1, within(0x1p-7));
  }

  /** What overlaps from the start is not pushed apart. */
  @Test
  void anOverlapFromTheStartStays() {
    SceneBuilder scene = falling(10).line(-20, 0, 20, 0).circle(0, 1, 1, 0, 0).restitution(0);
    World world = new World(scene.circle(1, 1, 1, 0, 0).restitution(0).build());
    world.advanceTo(10);
    assertThat(world.x(1) - world.x(0)).isCloseTo(1, within(1e-9));
  }
}
