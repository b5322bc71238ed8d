// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Contact with lines and outlines that turn, with gravity and without. */
class ContactTurningTest {

  private static final double STROKE = Math.toRadians(50);
  private static final double TIME = 0.025;

  /** The rate of a turn by an angle in a time, at a time of it. */
  private static double rate(double angle, double time, double t) {
    double part = t / time;
    double sine = Math.sin(angle / 4);
    return 2 * Math.sin(angle / 2) / time / (1 - 4 * part * (1 - part) * sine * sine);
  }

  /** The angle by which it has turned by then. */
  private static double turned(double angle, double time, double t) {
    double part = t / time;
    double re = 1 - part + part * Math.cos(angle / 2);
    return 2 * Math.atan2(part * Math.sin(angle / 2), re);
  }

  /**
   * Of a ball of radius r that stays on a line from the pivot, from a place and a speed along it:
   * {@code s' = u + w r, u' = w^2 s - g sin(angle)}. Returns s and u.
   */
  private static double[] slide(
      double s0,
      double u0,
      double r,
      double g,
      double angle,
      double time,
      double from,
      double end) {
    double s = s0;
    double u = u0;
    int steps = 100_000;
    double h = (end - from) / steps;
    for (int k = 0; k < steps; k++) {
      double t = from + (k + 0.5) * h;
      double w = rate(angle, time, t);
      double pull = g * Math.sin(turned(angle, time, t));
      double sm = s + (u + w * r) * h / 2;
      double um = u + (w * w * s - pull) * h / 2;
      s += (um + w * r) * h;
      u += (w * w * sm - pull) * h;
    }
    return new double[] {s, u};
  }

  /** A line from the origin, which is to turn there. */
  private static SceneBuilder line(double length, double e, double g, boolean collide) {
    return Scene.builder().gravity(0, -g).collide(collide).line(0, 0, length, 0).restitution(e);
  }

  private static double gap(World world, int line, int ball) {
    Vec2 center = new Vec2(world.x(ball), world.y(ball));
    Vec2 near = world.line(line).closestPoint(center);
    return Math.hypot(center.x() - near.x(), center.y() - near.y()) - world.radius(ball);
  }

  private static double along(World world, int line) {
    Line l = world.line(line);
    return (world.x(0) * l.bx() + world.y(0) * l.by()) / l.length();
  }

  // One ball.

  /** Struck without bounce it stays on, and slides outwards as {@code s'' = w^2 s} says. */
  @ParameterizedTest
  @CsvSource({"false, 0", "true, 0", "false, 500", "true, 500"})
  void aBallThatIsStruckWithoutBounceSlidesOutwards(boolean collide, double g) {
    for (double s : new double[] {6, 12, 40}) {
      World world = new World(line(200, 0, g, collide).circle(s, 3, 3, 0, 0).build());
      world.turn(Kind.LINE, 0, 0, 0, STROKE, TIME);
      int rows = 0;
      for (double t = 0.001; t < 0.0245; t += 0.001) {
        world.advanceTo(t);
        rows += world.impacts().size();
        double expected = slide(s, 0, 3, g, STROKE, TIME, 0, t)[0];
        assertThat(along(world, 0)).as("%s at %s", s, t).isCloseTo(expected, within(0.005 * s));
        assertThat(gap(world, 0, 0)).isBetween(-1e-9, 0.03);
      }
      assertThat(rows).as("impacts").isLessThan(4);
    }
  }

  /** When the turn ends nothing holds the ball: it flies straight, as fast as it was. */
  @CollidingOrNot
  void atTheEndItFliesFreely(boolean collide) {
    World world = new World(line(60, 0, 0, collide).circle(12, 3, 3, 0, 0).build());
    world.turn(Kind.LINE, 0, 0, 0, STROKE, TIME);
    world.advanceTo(TIME + 0.001);
    double vx = world.vx(0);
    double vy = world.vy(0);
    double x = world.x(0);
    double y = world.y(0);
    double[] end = slide(12, 0, 3, 0, STROKE, TIME, 0, TIME);
    double speed = Math.hypot(end[1], rate(STROKE, TIME, TIME) * end[0]);
    assertThat(Math.hypot(vx, vy)).isCloseTo(speed, within(0.01 * speed));
    world.advanceTo(TIME + 1.001);
    assertThat(world.impacts().size()).isZero();
    assertThat(world.x(0)).isCloseTo(x + vx, within(1e-9 * speed));
    assertThat(world.y(0)).isCloseTo(y + vy, within(1e-9 * speed));
    assertThat(world.vx(0)).isEqualTo(vx);
  }

  /** A ball rests on a flipper under gravity; then comes the stroke. */
  @ParameterizedTest
  @CsvSource({"0, false", "0, true", "0.5, false", "0.5, true", "1, true"})
  void aFlipperRaisesARestingBall(double e, boolean collide) {
    World world = new World(line(60, e, 500, collide).circle(20, 4, 4, 0, 0).build());
    world.advanceTo(0.1);
    if (e < 1) {
      assertThat(world.isResting(0)).isTrue();
    }
    double begin = world.now();
    world.turn(Kind.LINE, 0, 0, 0, STROKE, begin + TIME);
    double strike = rate(STROKE, TIME, 0) * 20;
    double first = 0;
    for (int k = 1; k <= 60; k++) {
      world.advanceTo(begin + k * 0.0005);
      if (first == 0 && world.impacts().size() > 0) {
        first = world.impacts().get(0).approachSpeed();
      }
      assertThat(gap(world, 0, 0)).as("at %s", world.now() - begin).isGreaterThan(-1e-8);
    }
    assertThat(first).isCloseTo(strike, within((e < 1 ? 1e-9 : 1e-3) * strike));
    assertThat(world.isResting(0)).isFalse();
    double speed = Math.hypot(world.vx(0), world.vy(0));
    if (e == 0) {
      double[] end = slide(20, 0, 4, 500, STROKE, TIME, 0, TIME);
      double expected = Math.hypot(end[1], rate(STROKE, TIME, TIME) * end[0]);
      assertThat(speed).isCloseTo(expected, within(0.01 * expected));
    } else {
      assertThat(speed).isGreaterThan((1 + e) * strike * 0.95);
    }
  }

  /** It rolls down a line that tilts slowly. */
  @ParameterizedTest
  @CsvSource({"0, false", "0.5, false", "0, true", "0.5, true"})
  void aBallRollsDownALineThatTilts(double e, boolean collide) {
    World world = new World(line(400, e, 100, collide).circle(200, 4, 4, 0, 0).build());
    world.advanceTo(0.1);
    world.turn(Kind.LINE, 0, 0, 0, 0.3, 2.1);
    world.advanceTo(2);
    double expected = slide(200, 0, 4, 100, 0.3, 2, 0, 1.9)[0];
    assertThat(along(world, 0)).isCloseTo(expected, within(e == 0 ? 0.5 : 15));
    assertThat(gap(world, 0, 0)).isBetween(-1e-9, 0.04);
  }

  /** A driven seesaw carries a ball, and lets it roll to and fro. */
  @Test
  void aSeesawCarriesABall() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -100)
                .line(-100, 0, 100, 0)
                .line(-100, 0, -100, 20)
                .line(100, 0, 100, 20)
                .restitution(0.3)
                .circle(0, 4, 4, 0, 0)
                .build());
    double least = 0;
    double most = 0;
    for (int k = 0; k < 40; k++) {
      double angle = (k / 5) % 4 == 0 || (k / 5) % 4 == 3 ? 0.04 : -0.04;
      for (int side = 0; side < 3; side++) {
        world.turn(Kind.LINE, side, 0, 0, angle, (k + 1) * 0.25);
      }
      for (int part = 1; part <= 20; part++) {
        world.advanceTo(k * 0.25 + part * 0.0125);
        for (int side = 0; side < 3; side++) {
          assertThat(gap(world, side, 0)).isGreaterThan(-1e-8);
        }
        least = Math.min(least, world.x(0));
        most = Math.max(most, world.x(0));
      }
      Line floor = world.line(0);
      double height =
          (world.y(0) * (floor.bx() - floor.ax()) - world.x(0) * (floor.by() - floor.ay())) / 200;
      assertThat(height).as("above it").isBetween(3.9, 60.0);
    }
    assertThat(least).isLessThan(-10);
    assertThat(most).isGreaterThan(10);
  }

  // Endless series.

  /**
   * Balls at a line that turns, with any bounce below 1. As seen from it the energy of a ball, less
   * {@code w^2 s^2 / 2}, never grows: so speeds are bounded.
   */
  @ParameterizedTest
  @CsvSource({"0, false", "0, true", "500, false", "500, true"})
  void noSeriesIsEndless(double g, boolean collide) {
    int balls = Integer.getInteger("carom.contacts", 0) > 0 ? 2_000 : 200;
    Random random = new Random(1);
    double worst = 0;
    long impacts = 0;
    for (int i = 0; i < balls; i++) {
      double length = 10 + 50 * random.nextDouble();
      double r = 1 + 4 * random.nextDouble();
      double angle = (random.nextDouble() - 0.5) * Math.PI;
      double time = Math.pow(10, -2.5 * random.nextDouble());
      double e = 0.9 * random.nextDouble();
      double v = length * Math.abs(angle) / time * Math.pow(random.nextDouble(), 3);
      double direction = 2 * Math.PI * random.nextDouble();
      double x = random.nextDouble() * (length + r);
      boolean isInTheWay = random.nextInt(8) > 0;
      double y = (isInTheWay == angle > 0 ? 1 : -1) * r * (1 + random.nextDouble());
      World world =
          new World(
              line(length, e, g, collide)
                  .circle(x, y, r, v * Math.cos(direction), v * Math.sin(direction))
                  .build());
      world.turn(Kind.LINE, 0, 0, 0, angle, time);
      double w = 2.4 * Math.abs(angle) / time / 2;
      double most = 1.1 * (v + 3 * w * (length + r)) + 2 * g * time + Math.sqrt(8 * g * length);
      for (int k = 1; k <= 100; k++) {
        world.advanceTo(1.2 * time * k / 100);
        impacts += world.impacts().size();
        worst = Math.max(worst, -gap(world, 0, 0) / r);
        assertThat(Math.hypot(world.vx(0), world.vy(0))).as("ball %s", i).isLessThan(most);
      }
      assertThat(worst).as("overlap of ball %s", i).isLessThan(1e-8);
    }
    assertThat(impacts).isBetween((long) balls, 60L * balls);
  }

  // Wedges and stops.

  /**
   * In a wedge that closes a ball is pushed out; {@code r w / (2 sin^2(angle / 2))} is its speed.
   */
  @ParameterizedTest
  @CsvSource({"0, false, 0", "0.5, false, 0", "0, true, 0", "0.9, true, 0", "0.5, true, 200"})
  void aWedgeThatClosesPushesABallOut(double e, boolean collide, double g) {
    double angle = 1.2;
    double s = 5 / Math.tan(angle / 2);
    World world =
        new World(
            Scene.builder()
                .gravity(-g, 0)
                .collide(collide)
                .line(0, 0, 100, 0)
                .line(0, 0, 100 * Math.cos(angle), 100 * Math.sin(angle))
                .restitution(e)
                .circle(s + 0.01, 5, 5, 0, 0)
                .build());
    world.turn(Kind.LINE, 1, 0, 0, -0.9, 1);
    for (int k = 1; k <= 100; k++) {
      world.advanceTo(k / 100.0);
      assertThat(gap(world, 0, 0)).as("at %s", k).isGreaterThan(-5e-8);
      assertThat(gap(world, 1, 0)).as("at %s", k).isGreaterThan(-5e-8);
      for (Impact hit : world.impacts()) {
        assertThat(hit.outcome()).as("at %s", k).isNotEqualTo(Outcome.JAMMED);
      }
    }
    assertThat(world.x(0)).isGreaterThan(5 / Math.tan(0.15) - 1e-6);
    if (g > 0) { // it stays in the wedge until it stops
      double speed = rate(0.9, 1, 1) * 5 / (2 * Math.pow(Math.sin(0.15), 2));
      assertThat(world.vx(0)).isCloseTo(speed, within(0.1 * speed));
    }
  }

  @ParameterizedTest
  @CsvSource({"0, false, 0", "0.5, true, 0", "0.9, true, 0", "0.5, false, 100", "0.5, true, 100"})
  void againstAStopABallIsCrushedAndTheLogSaysSo(double e, boolean collide, double g) {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -g)
                .collide(collide)
                .line(0, 0, 100, 0)
                .line(40, 12, 60, 12)
                .line(40, -20, 40, 12)
                .line(60, -20, 60, 12)
                .restitution(e)
                .circle(50, 5, 5, 0, 0)
                .build());
    world.advanceTo(0.5);
    world.turn(Kind.LINE, 0, 0, 0, 0.6, 1.5);
    boolean isJammed = false;
    for (int k = 1; k <= 300; k++) {
      world.advanceTo(0.5 + k / 100.0);
      for (Impact hit : world.impacts()) {
        isJammed |= hit.outcome() == Outcome.JAMMED;
      }
      if (!isJammed) {
        assertThat(gap(world, 0, 0)).isGreaterThan(-1e-8);
      }
      assertThat(gap(world, 1, 0)).isGreaterThan(-1e-8);
    }
    assertThat(isJammed).isTrue();
  }

  /** One of infinite mass has the velocity of the line; then it stops, and that passes over it. */
  @ParameterizedTest
  @CsvSource({"0, false, 0", "0, true, 100", "0.5, true, 0", "0.5, false, 100"})
  void aLinePassesOverWhatHasInfiniteMass(double e, boolean collide, double g) {
    World world =
        new World(
            line(60, e, g, collide).circle(20, 4, 4, 0, 0).mass(Double.POSITIVE_INFINITY).build());
    for (int k = 0; k < 6; k++) {
      world.turn(Kind.LINE, 0, 0, 0, k % 2 == 0 ? 1.5 : -1.5, world.now() + 0.5);
      world.advanceTo(world.now() + 0.5);
      double speed = Math.hypot(world.vx(0), world.vy(0));
      assertThat(speed).isLessThan(2_000);
      if (k == 0) {
        ImpactLog log = world.impacts();
        assertThat(log.outcome(log.size() - 1)).isEqualTo(Outcome.JAMMED);
        assertThat(speed).isZero();
      }
    }
    assertThat(world.vx(0) > 0).isEqualTo(e > 0); // the next impact has freed it
  }

  /** Without gravity also in contact: a ball that is pushed slides along, and comes no nearer. */
  @CollidingOrNot
  void aOneWayLineStopsABallThatOverlapsIt(boolean collide) {
    World world =
        new World(
            line(60, 0, 0, collide).line(17, 100, 17, -50).oneWay().circle(20, 4, 4, 0, 0).build());
    world.turn(Kind.LINE, 0, 0, 0, 0.8, 1);
    for (int k = 1; k <= 100; k++) {
      world.advanceTo(k / 100.0);
      assertThat(world.x(0)).as("at %s", k).isGreaterThan(20 - 1e-9);
      assertThat(gap(world, 0, 0)).as("at %s", k).isGreaterThan(-1e-8);
    }
    assertThat(world.y(0)).isGreaterThan(20);
  }

  /** Solid from outside, and from its left: a ball inside of them leaves. */
  @ParameterizedTest
  @CsvSource({"0", "300"})
  void aPolygonAndAOneWayLineCarryFromOutside(double g) {
    Outline paddle = Outline.rectangle(0, -10, 80, 0);
    World world =
        new World(
            Scene.builder()
                .gravity(0, -g)
                .outline(paddle)
                .restitution(0.25)
                .line(-10, 0, -90, 0)
                .oneWay()
                .restitution(0.25)
                .circle(40, 4, 4, 0, 0) // on the polygon
                .circle(40, -5, 4, 0, 0) // in it
                .circle(-40, -4, 4, 0, 0) // on the left of the line
                .circle(-60, 4, 4, 0, 0) // on its right
                .build());
    for (int k = 0; k < 50; k++) {
      if (k % 25 == 0) {
        double angle = k == 0 ? 0.5 : -0.5;
        world.turn(Kind.LINE, 0, 0, 0, angle, world.now() + 0.25);
        world.turn(Kind.LINE, 1, 0, 0, angle, world.now() + 0.25);
      }
      world.advanceTo(world.now() + 0.01);
      Outline solid = (Outline) world.shape(Kind.LINE, 0);
      Vec2 center = new Vec2(world.x(0), world.y(0));
      for (int side = 0; side < 4; side++) {
        Vec2 near = solid.side(side).closestPoint(center);
        double gap = Math.hypot(near.x() - center.x(), near.y() - center.y()) - 4;
        assertThat(gap).as("at %s", k).isGreaterThan(-1e-8);
      }
      if (k < 24) {
        assertThat(gap(world, 1, 2)).isGreaterThan(-1e-8);
      }
    }
    assertThat(world.impacts().size()).isLessThan(10);
  }

  // Crowds.

  private static void fill(SceneBuilder scene, int balls, double x, double y, double e) {
    Random random = new Random(balls);
    for (int i = 0; i < balls; i++) {
      double px = x + i % 6 * 11 + random.nextDouble();
      scene.circle(px, y + i / 6 * 11 + random.nextDouble(), 5, 0, 0).restitution(Math.sqrt(e));
    }
  }

  private static World bucket(double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -200);
    scene.line(-40, 80, -35, 0).restitution(Math.sqrt(e));
    scene.line(-35, 0, 35, 0).restitution(Math.sqrt(e));
    scene.line(35, 0, 40, 80).restitution(Math.sqrt(e));
    fill(scene, 24, -28, 8, e);
    return new World(scene.build());
  }

  private static void swing(World world, int k) {
    double angle = k % 4 == 0 || k % 4 == 3 ? 0.25 : -0.25;
    for (int side = 0; side < 3; side++) {
      world.turn(Kind.LINE, side, 0, 30, angle, world.now() + 0.5);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5})
  void aBucketThatSwingsKeepsItsBalls(double e) {
    World world = bucket(e);
    ContactRun run = new ContactRun(world).withMovers();
    for (int k = 0; k < 12; k++) {
      swing(world, k);
      run.play((k + 1) * 0.5, 1 / 64.0);
      assertThat(run.faults()).as("swing %s", k).isEmpty();
      assertThat(run.jammed).isEmpty();
    }
  }

  private static World mill(double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -200).bounds(-80, -60, 80, 200);
    scene.line(-30, 0, 30, 0).restitution(Math.sqrt(e));
    scene.line(0, -30, 0, 30).restitution(Math.sqrt(e));
    fill(scene, 30, -30, 40, e);
    return new World(scene.build());
  }

  /** A windmill in a heap: what it cannot pass it passes over, and says so. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5})
  void aWindmillTurnsInAHeap(double e) {
    World world = mill(e);
    ContactRun run = new ContactRun(world).withMovers();
    double angle = 0;
    for (int k = 0; k < 120; k++) {
      angle += 0.05;
      for (int blade = 0; blade < 2; blade++) {
        world.turn(Kind.LINE, blade, 0, 0, 0.05, world.now() + 1 / 32.0);
      }
      run.play((k + 1) / 32.0, 1 / 64.0);
      assertThat(run.faults()).as("frame %s", k).isEmpty();
    }
    Line blade = world.line(0);
    assertThat(Math.sin(Math.atan2(blade.by(), blade.bx()) - angle)).isCloseTo(0, within(1e-12));
    assertThat(run.jammed.size()).isLessThan(8);
  }

  // The same by other means.

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void frameByFrameOrAtOnceItIsTheSame(boolean swings) {
    World world = swings ? bucket(0.5) : mill(0.5);
    World sliced = swings ? bucket(0.5) : mill(0.5);
    for (int k = 0; k < 6; k++) {
      for (World each : List.of(world, sliced)) {
        if (swings) {
          swing(each, k);
        } else {
          each.turn(Kind.LINE, 0, 0, 0, 1, each.now() + 0.4);
          each.turn(Kind.LINE, 1, 0, 0, 1, each.now() + 0.4);
        }
      }
      double end = (k + 1) * 0.5;
      world.advanceTo(end);
      for (int part = 1; part <= 200; part++) {
        sliced.advanceTo(k * 0.5 + part / 400.0);
        World restored = new World(world.scene());
        restored.restore(sliced.snapshot());
        sliced = restored;
      }
      assertThat(sliced.snapshot()).as("after %s", end).isEqualTo(world.snapshot());
    }
  }

  @Test
  void withoutGravitySlicesMirrorsAndScalesAreTheSame() {
    List<World> worlds = new ArrayList<>();
    double small = 0x1p-10;
    worlds.add(struck(1, 1));
    worlds.add(struck(1, -1));
    worlds.add(struck(small, 1));
    worlds.add(struck(1, 1)); // and restored
    for (int k = 1; k <= 200; k++) {
      for (int w = 0; w < 4; w++) {
        World world = worlds.get(w);
        if (k % 40 == 1) {
          double angle = (w == 1 ? -1 : 1) * (k % 80 == 1 ? 0.7 : -0.7);
          world.turn(Kind.LINE, 0, 0, 0, angle, k * 0.03 + 0.8);
        }
        world.advanceTo(k * 0.03);
        if (w == 3) {
          World restored = new World(world.scene());
          restored.restore(world.snapshot());
          worlds.set(3, restored);
        }
      }
      World world = worlds.get(0);
      assertThat(worlds.get(3).snapshot()).as("frame %s", k).isEqualTo(world.snapshot());
      for (int i = 0; i < 4; i++) {
        assertThat(worlds.get(1).x(i)).as("%s in frame %s", i, k).isEqualTo(world.x(i));
        assertThat(worlds.get(1).y(i)).as("%s in frame %s", i, k).isEqualTo(-world.y(i));
        assertThat(worlds.get(2).x(i)).as("%s in frame %s", i, k).isEqualTo(small * world.x(i));
      }
    }
  }

  /**
   * So large and slow that what pulls a circle underflows: contact has no clock for it. It leaves
   * and bounces on, and {@code advanceTo} says that this is too much, but no line passes over it.
   */
  @CollidingOrNot
  void whereTheAccelerationUnderflowsNoLinePassesOverABall(boolean collide) {
    double l = 0x1p480;
    double time = 0x1p900;
    World world = new World(line(40 * l, 0, 0, collide).circle(20 * l, 4 * l, 4 * l, 0, 0).build());
    world.turn(Kind.LINE, 0, 0, 0, 1, time);
    assertThatThrownBy(() -> world.advanceTo(time / 40)).isInstanceOf(UnfinishedException.class);
    assertThat(gap(world, 0, 0)).isGreaterThan(-1e-8 * l);
  }

  private static World struck(double l, int mirror) {
    SceneBuilder scene = Scene.builder().bounds(-50 * l, -50 * l, 50 * l, 50 * l).restitution(0.5);
    scene.line(0, 0, 40 * l, 0).restitution(0.25);
    for (int i = 0; i < 4; i++) {
      double y = mirror * (i % 2 == 0 ? 4 : -4) * l;
      scene.circle((8 + 10 * i) * l, y, 3 * l, i * l, 0).restitution(0.75);
    }
    return new World(scene.build());
  }
}
