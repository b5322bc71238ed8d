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

/** Lines, outlines and pegs that turn about a pivot until a time, and then rest. */
class TurnTest {

  private static final double QUARTER = Math.PI / 2;

  /** A flipper of length 30 at 0, which points to the right and down by 30 degrees. */
  private static final double DOWN = Math.toRadians(-30);

  private static SceneBuilder flipper() {
    return Scene.builder().line(0, 0, 30 * Math.cos(DOWN), 30 * Math.sin(DOWN));
  }

  private static double angle(Line line) {
    return Math.atan2(line.by() - line.ay(), line.bx() - line.ax());
  }

  // The motion.

  @Test
  void itArrivesToTheBitWhereTheAngleLeadsAndRestsThere() {
    Random random = new Random(1);
    World world = new World(Scene.builder().line(0.1, 0.2, 3, 4).build());
    double most = 0;
    for (int i = 0; i < 2000; i++) {
      Line before = world.line(0);
      double x = random.nextGaussian();
      double y = random.nextGaussian();
      double angle = QUARTER * (2 * random.nextDouble() - 1);
      double arrival = world.now() + random.nextDouble();
      world.turn(Kind.LINE, 0, x, y, angle, arrival);
      world.advanceTo(arrival);
      Line there = world.line(0);
      assertThat(world.velocity(Kind.LINE, 0)).isEqualTo(Vec2.ZERO);
      double dx = before.bx() - x;
      double dy = before.by() - y;
      double exactX = x + dx * Math.cos(angle) - dy * Math.sin(angle);
      double exactY = y + dx * Math.sin(angle) + dy * Math.cos(angle);
      double size = Math.abs(x) + Math.abs(y) + Math.hypot(dx, dy);
      most = Math.max(most, Math.hypot(there.bx() - exactX, there.by() - exactY) / size);
      world.advanceTo(arrival + random.nextDouble());
      assertThat(world.line(0)).isEqualTo(there);
      world.setShape(Kind.LINE, 0, new Line(random.nextDouble(), 0.2, 3, 4));
    }
    assertThat(most).isLessThan(6e-16);
  }

  /** By the rounding of the place then, of the vector from the pivot, and of its rotation. */
  @Test
  void thePlaceStepsAtTheCallByNoMoreThanRounding() {
    Random random = new Random(2);
    World world = new World(Scene.builder().line(0.1, 0.2, 3, 4).build());
    double most = 0;
    for (int i = 0; i < 20_000; i++) {
      Line before = world.line(0);
      double angle = QUARTER * (2 * random.nextDouble() - 1);
      double arrival = world.now() + random.nextDouble();
      double pivot = random.nextGaussian();
      world.turn(Kind.LINE, 0, pivot, 1, angle, arrival);
      Line after = world.line(0);
      double step = Math.hypot(after.bx() - before.bx(), after.by() - before.by());
      double reach = Math.hypot(before.bx() - pivot, before.by() - 1);
      double bound = 0x1p-50 * (Math.hypot(before.bx(), before.by()) + reach);
      assertThat(step).isLessThan(bound);
      most = Math.max(most, step / bound);
      world.advanceTo(world.now() + random.nextDouble() * (arrival - world.now()));
      if (Math.hypot(after.bx(), after.by()) > 9) {
        world.setShape(Kind.LINE, 0, new Line(0.1, 0.2, 3, 4));
      }
    }
    assertThat(most).isGreaterThan(0.1); // the bound is not idle
  }

  /** Halfway in time it is halfway in angle; its rate is that of c, see World.turn. */
  @Test
  void itTurnsRigidlyAndNearlyEvenly() {
    World world = new World(flipper().build());
    double angle = Math.toRadians(45);
    world.turn(Kind.LINE, 0, 0, 0, angle, 1);
    world.advanceTo(0.5);
    assertThat(angle(world.line(0))).isCloseTo(DOWN + angle / 2, within(1e-15));
    double inTheMiddle = rate(world, 0.5);
    double atTheStart = rate(world, 2e-6);
    double tangent = Math.tan(angle / 4);
    assertThat(inTheMiddle / atTheStart).isCloseTo(1 + tangent * tangent, within(1e-5));
    for (double t = 0.6; t < 1; t += 0.1) {
      world.advanceTo(t);
      assertThat(world.line(0).length()).isCloseTo(30, within(1e-14));
      assertThat(world.line(0).start()).isEqualTo(new Vec2(0, 0));
    }
  }

  private static double rate(World world, double t) {
    World copy = new World(world.scene());
    copy.turn(Kind.LINE, 0, 0, 0, Math.toRadians(45), 1);
    copy.advanceTo(t - 1e-6);
    double before = angle(copy.line(0));
    copy.advanceTo(t + 1e-6);
    return (angle(copy.line(0)) - before) / 2e-6;
  }

  @Test
  void theVelocityIsThatOfTheFirstPoint() {
    World world = new World(Scene.builder().line(3, 0, 9, 0).peg(0, 2, 1).build());
    world.turn(Kind.LINE, 0, 0, 0, QUARTER, 1);
    world.turn(Kind.PEG, 0, 0, 0, QUARTER, 1);
    world.advanceTo(0.5);
    double rate = 2 * Math.sin(Math.PI / 8) * 2 / Math.pow(Math.cos(Math.PI / 8), 1);
    double part = rate * Math.sqrt(0.5);
    assertThat(world.velocity(Kind.LINE, 0).x()).isCloseTo(-3 * part, within(1e-14));
    assertThat(world.velocity(Kind.LINE, 0).y()).isCloseTo(3 * part, within(1e-14));
    assertThat(world.velocity(Kind.PEG, 0).x()).isCloseTo(-2 * part, within(1e-14));
    assertThat(world.velocity(Kind.PEG, 0).y()).isCloseTo(-2 * part, within(1e-14));
    world.advanceTo(1);
    assertThat(world.velocity(Kind.LINE, 0)).isEqualTo(Vec2.ZERO);
    assertThat(world.line(0).start().x()).isCloseTo(0, within(1e-15));
    assertThat(world.peg(0).center().x()).isCloseTo(-2, within(1e-15));
  }

  @Test
  void thereAndBackItIsWhereItWas() {
    World world = new World(flipper().build());
    Line before = world.line(0);
    for (int i = 0; i < 1000; i++) {
      world.turn(Kind.LINE, 0, 0, 0, 1, world.now() + 0.01);
      world.step(0.02);
      world.turn(Kind.LINE, 0, 0, 0, -1, world.now() + 0.01);
      world.step(0.02);
    }
    assertThat(world.line(0).start()).isEqualTo(before.start());
    assertThat(world.line(0).bx()).isCloseTo(before.bx(), within(1e-12));
    assertThat(world.line(0).by()).isCloseTo(before.by(), within(1e-12));
  }

  @Test
  void anotherEditReplacesTheMotion() {
    World world = new World(flipper().build());
    world.turn(Kind.LINE, 0, 0, 0, 1, 1);
    world.advanceTo(0.5);
    world.turn(Kind.LINE, 0, 0, 0, -1, 1); // back from halfway
    world.advanceTo(2);
    assertThat(angle(world.line(0))).isCloseTo(DOWN - 0.5, within(1e-15));
    world.turn(Kind.LINE, 0, 0, 0, 1, 3);
    world.advanceTo(2.5);
    Line there = world.line(0);
    world.setVelocity(Kind.LINE, 0, 1, 0);
    world.advanceTo(3.5); // past the arrival
    assertThat(world.line(0).bx()).isCloseTo(there.bx() + 1, within(1e-14));
    assertThat(world.line(0).by()).isEqualTo(there.by());
    world.turn(Kind.LINE, 0, 1, 0, 1, 5);
    world.moveTo(Kind.LINE, 0, 7, 8, 4);
    world.advanceTo(6);
    assertThat(world.line(0).start()).isEqualTo(new Vec2(7, 8));
    world.turn(Kind.LINE, 0, 7, 8, 1, 7);
    world.moveTo(Kind.LINE, 0, 7, 8, 7); // no motion but to stop it
    Line stopped = world.line(0);
    world.advanceTo(7);
    assertThat(world.line(0)).isEqualTo(stopped);
    world.turn(Kind.LINE, 0, 7, 8, 1, 9);
    world.advanceTo(8);
    world.setShape(Kind.LINE, 0, new Line(1, 2, 3, 4));
    world.advanceTo(10);
    assertThat(world.line(0)).isEqualTo(new Line(1, 2, 3, 4));
    world.turn(Kind.LINE, 0, 7, 8, 1, 12);
    world.advanceTo(11);
    world.remove(Kind.LINE, 0);
    world.advanceTo(20);
    assertThat(world.contains(Kind.LINE, 0)).isFalse();
  }

  /** A peg about its centre, and anything by no angle. */
  @Test
  void aTurnThatMovesNothingIsNone() {
    World world = new World(flipper().peg(50, 60, 7).build());
    Line line = world.line(0);
    world.turn(Kind.LINE, 0, 0, 0, 0.0, 1);
    world.turn(Kind.PEG, 0, 50, 60, 1, 1);
    assertThat(world.velocity(Kind.PEG, 0)).isEqualTo(Vec2.ZERO);
    world.advanceTo(2);
    assertThat(world.line(0)).isEqualTo(line);
    assertThat(world.peg(0)).isEqualTo(new Circle(50, 60, 7));
  }

  @Test
  void theSidesOfAnOutlineStayJoined() {
    Random random = new Random(3);
    Outline star = Outline.polygon(0, 0, 10, 1, 11, 7, 4, 3, 0.3, 9.7);
    World world = new World(Scene.builder().outline(star).build());
    for (int i = 0; i < 300; i++) {
      double angle = QUARTER * (2 * random.nextDouble() - 1);
      world.turn(Kind.LINE, 0, 3, random.nextInt(20), angle, world.now() + 0.3);
      world.step(0.5 * random.nextDouble());
      Outline now = (Outline) world.shape(Kind.LINE, 0);
      assertThat(now.points()).hasSize(5);
      for (int k = 0; k < 5; k++) {
        assertThat(now.side(k).length()).isCloseTo(star.side(k).length(), within(1e-11));
      }
    }
  }

  @Test
  void whatWouldGoTooFarOrTooFastIsRefused() {
    World world = new World(Scene.builder().line(3, 4, 5, 0).circle(50, 50, 1, 0, 0).build());
    Snapshot before = world.snapshot();
    String tooLarge = ": expected a smaller one: 2^10 ulps of it must not exceed the least radius";
    assertThatThrownBy(() -> world.turn(Kind.LINE, 0, 0, 0, 1, Double.MIN_VALUE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("line 0: arrival is 4.9E-324: expected late enough after 0.0 for this way");
    double far = 0.8 * 0x1p43; // coordinates must be below 2^43
    assertThatThrownBy(() -> world.turn(Kind.LINE, 0, far, -far, QUARTER, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("line 0: ay is ")
        .hasMessageContaining(tooLarge);
    // Both ends of the arc are at 0.99 of the limit, and its middle is beyond.
    double most = 0.99 * 0x1p43;
    world.setShape(Kind.LINE, 0, new Line(most, most, 0, 0));
    Snapshot shaped = world.snapshot();
    assertThatThrownBy(() -> world.turn(Kind.LINE, 0, 0, 0, -QUARTER, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("line 0: ax is " + Math.hypot(most, most))
        .hasMessageContaining(tooLarge);
    assertThat(world.snapshot()).isEqualTo(shaped).isNotEqualTo(before);
  }

  // Circles in the way.

  /**
   * A ball at rest at the distance rho, seen at the angle phi, is touched when the line is at
   * {@code phi - asin(r / rho)}. It is struck with the velocity of the point of the line that
   * touches it.
   */
  @ParameterizedTest
  @CsvSource({"0, false", "0.5, false", "1, false", "0, true", "0.5, true", "1, true"})
  void aBallAtRestIsStruckAsTheoryTells(double e, boolean collide) {
    Random random = new Random(4);
    double angle = Math.toRadians(50);
    double duration = 0.025;
    for (int i = 0; i < 200; i++) {
      double r = 0.5 + 3 * random.nextDouble();
      double to = angle * (0.1 + 0.8 * random.nextDouble()); // where they touch, from the start
      double along = 5 + 24 * random.nextDouble();
      double phi = DOWN + to + Math.atan2(r, along);
      double rho = Math.hypot(along, r);
      World world =
          new World(
              flipper()
                  .restitution(e)
                  .circle(rho * Math.cos(phi), rho * Math.sin(phi), r, 0, 0)
                  .collide(collide)
                  .build());
      world.turn(Kind.LINE, 0, 0, 0, angle, duration);
      assertThat(world.advanceToImpact(1)).isTrue();
      double sine = Math.sin(to / 2);
      double part = sine / (sine + Math.sin((angle - to) / 2));
      double square = 1 - 4 * part * (1 - part) * Math.pow(Math.sin(angle / 4), 2); // |c|^2
      double rate = 2 * Math.sin(angle / 2) / duration / square;
      Impact hit = world.impacts().get(0);
      assertThat(hit.time()).isCloseTo(part * duration, within(1e-9 * duration));
      assertThat(hit.approachSpeed()).isCloseTo(rate * along, within(1e-9 * rate * along));
      double speed = (1 + e) * rate * along;
      double normal = DOWN + to + QUARTER;
      assertThat(world.vx(0)).isCloseTo(speed * Math.cos(normal), within(1e-9 * speed));
      assertThat(world.vy(0)).isCloseTo(speed * Math.sin(normal), within(1e-9 * speed));
    }
  }

  /** The key is pressed within a frame, and the stroke ends within it: one call, then one step. */
  @Test
  void aStrokeBeginsAndEndsWithinAFrame() {
    World world = new World(flipper().circle(20, 0, 3, 0, 0).build());
    world.advanceTo(1);
    world.advanceTo(1 + 0.2 / 30);
    world.turn(Kind.LINE, 0, 0, 0, Math.toRadians(50), world.now() + 0.025);
    world.advanceTo(1 + 1 / 30.0);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(angle(world.line(0))).isCloseTo(Math.toRadians(20), within(1e-15));
    assertThat(world.velocity(Kind.LINE, 0)).isEqualTo(Vec2.ZERO);
    assertThat(world.vy(0)).isPositive();
  }

  /** Beyond its arrival it strikes nothing. */
  @Test
  void itStopsAtItsArrival() {
    World world = new World(flipper().circle(0, 20, 3, 0, 0).build());
    world.turn(Kind.LINE, 0, 0, 0, Math.toRadians(50), 0.025);
    world.advanceTo(10);
    assertThat(world.impacts().size()).isZero();
    world.setVelocity(0, 5, -20);
    world.advanceTo(20);
    assertThat(world.impacts().size()).isEqualTo(1);
    Vec2 along = world.line(0).end();
    double before = 5 * along.x() - 20 * along.y();
    assertThat(world.vx(0) * along.x() + world.vy(0) * along.y())
        .isCloseTo(before, within(1e-10)); // the surface is smooth, and at rest
  }

  /**
   * A solid turning square, a one-way line and a sensor: from outside only, from its left only, and
   * without an effect.
   */
  @Test
  void solidsOneWayLinesAndSensorsTurnAsTheyRest() {
    Outline square = Outline.rectangle(-5, -5, 5, 5);
    World world = new World(Scene.builder().outline(square).circle(0, 0, 1, 30, 0).build());
    world.turn(Kind.LINE, 0, 0, 0, QUARTER, 1);
    world.advanceTo(2);
    assertThat(world.impacts().size()).isZero(); // out of it
    for (boolean left : new boolean[] {false, true}) {
      World gate =
          new World(
              Scene.builder().line(0, 0, 0, 10).oneWay().circle(left ? -3 : 3, 5, 1, 0, 0).build());
      gate.turn(Kind.LINE, 0, 0, 0, left ? 1 : -1, 1); // towards the ball
      gate.advanceTo(2);
      assertThat(gate.impacts().size()).isEqualTo(left ? 1 : 0);
    }
    World trap = new World(flipper().response(Response.SENSOR).circle(20, 0, 3, 0, 0).build());
    trap.turn(Kind.LINE, 0, 0, 0, 1, 1);
    trap.advanceTo(2);
    assertThat(trap.impacts().size()).isEqualTo(1);
    assertThat(trap.impacts().outcome(0)).isEqualTo(Outcome.SENSED);
    assertThat(trap.vx(0)).isZero();
  }

  @Test
  void aBallThatIsHitCanBeHitAgainBySameTurnWithoutGravity() {
    World world = new World(flipper().restitution(0.5).circle(10, 0, 1, 0, 0).build());
    world.turn(Kind.LINE, 0, 0, 0, QUARTER, 1);
    world.advanceTo(1);
    assertThat(world.impacts().size()).isGreaterThan(1);
    assertThat(gap(world, 0)).isGreaterThan(-1e-9);
  }

  private static double gap(World world, int ball) {
    Vec2 center = new Vec2(world.x(ball), world.y(ball));
    Vec2 near = world.line(0).closestPoint(center);
    return Math.hypot(center.x() - near.x(), center.y() - near.y()) - world.radius(ball);
  }

  /**
   * Balls at up to 10^4 radii a frame at a flipper in mid-stroke, from both sides: at none of 100
   * places of a flight does one overlap it. {@code -Dcarom.leaks=1000000} makes a longer run.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 1})
  void noBallLeaksThrough(double e) {
    int balls = Integer.getInteger("carom.leaks", 2_000);
    Random random = new Random(5);
    double worst = 0;
    int impacts = 0;
    for (int i = 0; i < balls; i++) {
      double angle = Math.toRadians(50) * (random.nextBoolean() ? 1 : -1);
      double begin = 0.01 * random.nextDouble();
      Line at = mid(angle, 0.01 * random.nextDouble() / 0.025);
      double speed = Math.pow(10, 4 * random.nextDouble()) * 60;
      double along = random.nextDouble();
      double direction = 2 * Math.PI * random.nextDouble();
      double flown = 0.02 * random.nextDouble();
      double x = along * at.bx() - speed * flown * Math.cos(direction);
      double y = along * at.by() - speed * flown * Math.sin(direction);
      World world =
          new World(
              flipper()
                  .restitution(e)
                  .circle(x, y, 1, speed * Math.cos(direction), speed * Math.sin(direction))
                  .collide(random.nextBoolean())
                  .build());
      if (gap(world, 0) < 0) {
        continue;
      }
      world.advanceTo(begin);
      if (gap(world, 0) < 0) {
        continue;
      }
      world.turn(Kind.LINE, 0, 0, 0, angle, begin + 0.025);
      for (int k = 1; k <= 100; k++) {
        world.advanceTo(begin + k * 0.0003);
        impacts += world.impacts().size();
        worst = Math.max(worst, -gap(world, 0));
      }
    }
    System.out.printf("e %s: %,d balls, %,d impacts, overlap %.1e%n", e, balls, impacts, worst);
    assertThat(worst).isLessThan(1e-8);
    assertThat(impacts).isGreaterThan(balls / 4);
  }

  private static Line mid(double angle, double part) {
    World world = new World(flipper().build());
    world.turn(Kind.LINE, 0, 0, 0, angle, 1);
    world.advanceTo(part);
    return world.line(0);
  }

  // The same by other means.

  private static World many(boolean collide, double gravity, double scale, int mirror) {
    Random random = new Random(6);
    double l = scale;
    SceneBuilder scene = Scene.builder().collide(collide).gravity(0, gravity * l * mirror);
    scene.bounds(-64 * l, -64 * l, 64 * l, 64 * l);
    scene.line(0, 0, 30 * l, -10 * l * mirror).peg(-20 * l, 0, 4 * l);
    scene.outline(square(l, mirror));
    for (int i = 0; i < 12; i++) {
      double x = l * (random.nextInt(100) - 50);
      double y = l * mirror * (random.nextBoolean() ? 30 + random.nextInt(20) : -25);
      double vx = l * random.nextInt(20);
      scene.circle(x, y, 2 * l, vx, l * mirror * random.nextInt(20)).restitution(0.875);
    }
    return new World(scene.build());
  }

  private static Outline square(double l, int mirror) {
    double low = mirror * -40 * l;
    double high = mirror * -30 * l;
    return Outline.polygon(-40 * l, low, -30 * l, low, -30 * l, high, -40 * l, high);
  }

  private static void drive(World world, int frame, double scale, int mirror) {
    double arrival = world.now() + 0.75;
    if (frame % 4 == 0) {
      double angle = mirror * (frame % 8 == 0 ? 1.0 : -1.0);
      world.turn(Kind.LINE, 0, 0, 0, angle, arrival);
      world.turn(Kind.PEG, 0, 0, 0, mirror * 1.5, arrival);
      world.turn(Kind.LINE, 1, -35 * scale, mirror * -35 * scale, mirror * 0.5, arrival);
    }
  }

  @ParameterizedTest
  @CsvSource({"false, 0", "false, -10", "true, 0", "true, -10"})
  void mirroredAndScaledItIsTheSame(boolean collide, double gravity) {
    World world = many(collide, gravity, 1, 1);
    World mirrored = many(collide, gravity, 1, -1);
    World scaled = many(collide, gravity, 0x1p-20, 1);
    int impacts = 0;
    for (int frame = 0; frame < 40; frame++) {
      drive(world, frame, 1, 1);
      drive(mirrored, frame, 1, -1);
      drive(scaled, frame, 0x1p-20, 1);
      for (World each : List.of(world, mirrored, scaled)) {
        each.advanceTo((frame + 1) / 4.0);
      }
      impacts += world.impacts().size();
      for (int i = 0; i < 12; i++) {
        assertThat(mirrored.x(i)).as("%s in frame %s", i, frame).isEqualTo(world.x(i));
        assertThat(mirrored.y(i)).isEqualTo(-world.y(i));
        assertThat(scaled.x(i)).as("%s in frame %s", i, frame).isEqualTo(0x1p-20 * world.x(i));
        assertThat(scaled.vy(i)).isEqualTo(0x1p-20 * world.vy(i));
      }
    }
    assertThat(impacts).isGreaterThan(40);
  }

  @ParameterizedTest
  @CsvSource({"false, 0", "false, -10", "true, 0", "true, -10"})
  void slicedAndRestoredItIsTheSame(boolean collide, double gravity) {
    World world = many(collide, gravity, 1, 1);
    World sliced = many(collide, gravity, 1, 1);
    Timeline past = world.record(100);
    List<Obstacle> shapes = new ArrayList<>();
    for (int frame = 0; frame < 40; frame++) {
      drive(world, frame, 1, 1);
      drive(sliced, frame, 1, 1);
      shapes.add(world.line(0));
      shapes.add(world.shape(Kind.LINE, 1));
      double end = (frame + 1) / 4.0;
      world.advanceTo(end);
      sliced.advanceTo(end - 0.2);
      World restored = new World(world.scene());
      restored.restore(sliced.snapshot());
      sliced = restored;
      sliced.advanceTo(end - 0.1);
      while (sliced.advanceToImpact(end)) {
        assertThat(sliced.impacts().size()).isPositive();
      }
      assertThat(sliced.snapshot()).as("frame %s", frame).isEqualTo(world.snapshot());
    }
    for (int frame = 0; frame < 40; frame++) {
      double t = frame / 4.0;
      assertThat(past.shape(Kind.LINE, 0, t)).isEqualTo(shapes.get(2 * frame));
      assertThat(past.shape(Kind.LINE, 1, t)).isEqualTo(shapes.get(2 * frame + 1));
      World then = new World(world.scene());
      then.restore(past.snapshot(t + 0.1));
      then.advanceTo(t + 0.2);
      World later = new World(world.scene());
      later.restore(past.snapshot(t + 0.2));
      assertThat(then.snapshot()).as("frame %s", frame).isEqualTo(later.snapshot());
    }
  }

  // Questions.

  @Test
  void questionsSeeItWhereItIs() {
    World world = new World(Scene.builder().line(0, 0, 10, 0).build());
    world.turn(Kind.LINE, 0, 0, 0, QUARTER, 1);
    world.advanceTo(0.5);
    Nearest nearest = world.nearest(0, 10 * Math.sqrt(2)).orElseThrow();
    assertThat(nearest.x()).isCloseTo(10 * Math.sqrt(0.5), within(1e-14));
    assertThat(nearest.distance()).isCloseTo(10, within(1e-14));
    assertThat(world.overlapping(Kind.LINE, new Circle(7, 7, 0.5))).containsExactly(0);
    assertThat(world.overlapping(Kind.LINE, new Circle(10, 0, 0.5))).isEmpty();
  }

  /** It stands upright from time 1 on, and is at 45 degrees at time 0.5. */
  @Test
  void aCastSeesItOnItsWayAndAtRest() {
    World world = new World(Scene.builder().line(0, 0, 10, 0).build());
    world.turn(Kind.LINE, 0, 0, 0, QUARTER, 1);
    SweptCircle slow = new SweptCircle(20, 5, 1, -1, 0);
    Impact atRest = world.cast(slow, 100).orElseThrow();
    assertThat(atRest.time()).isCloseTo(19, within(1e-15));
    assertThat(atRest.nx()).isCloseTo(1, within(1e-15));
    SweptCircle falling = new SweptCircle(5, 5 + 2 * Math.sqrt(0.5) + 0.5, 1, 0, -1);
    Impact onTheWay = world.cast(falling, 100).orElseThrow();
    assertThat(onTheWay.time()).isCloseTo(0.5, within(1e-15));
    double t = onTheWay.time();
    world.advanceTo(t);
    Vec2 center = falling.at(t).center();
    Vec2 near = world.line(0).closestPoint(center);
    assertThat(Math.hypot(center.x() - near.x(), center.y() - near.y()))
        .isCloseTo(1, within(1e-14));
    assertThat(onTheWay.point().x()).isCloseTo(near.x(), within(1e-14));
    assertThat(onTheWay.point().y()).isCloseTo(near.y(), within(1e-14));
  }

  /** Where circles ignore each other, a path is the one that the world goes. */
  @ParameterizedTest
  @ValueSource(doubles = {0, -10})
  void aTraceFollowsTheWorld(double gravity) {
    Random random = new Random(7);
    for (int i = 0; i < 40; i++) {
      Vec2 v = new Vec2(8 * random.nextDouble(), random.nextGaussian());
      World world =
          new World(
              Scene.builder()
                  .bounds(-20, -20, 20, 20)
                  .gravity(0, gravity)
                  .line(0, -10, 0, 10)
                  .line(-20, -5, 20, -5)
                  .circle(-15 + random.nextInt(12), 4, 0.5, v.x(), v.y())
                  .build());
      world.turn(Kind.LINE, 0, 0, 10, random.nextDouble() - 0.5, 1 + random.nextDouble());
      Trajectory path = world.trace(0, v.x(), v.y(), 5, 1000);
      for (int k = 1; k <= 50; k++) {
        world.advanceTo(k / 10.0);
        assertThat(path.at(k / 10.0).x()).as("%s at %s", i, k).isCloseTo(world.x(0), within(1e-9));
        assertThat(path.at(k / 10.0).y()).as("%s at %s", i, k).isCloseTo(world.y(0), within(1e-9));
      }
    }
  }
}
