// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A step allocates nothing, once the log has grown to the size that the scene needs. */
class AllocationTest {

  /** Frames after which the log's arrays have their size: those of the busiest frame are before. */
  private static final int WARM_UP = 3_000;

  /** One ulp more than the radius away: plain doubles leave open whether that touches. */
  private static final double TOUCHING = Math.nextUp(1.0);

  /** Where the last answer of many goes, for nobody to read. */
  @SuppressWarnings("UnusedVariable")
  private volatile Optional<Impact> answer;

  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "base-2.csv", "base-3.csv", "fast-1.csv", "radii.csv"})
  void framesAllocateNothing(String file) throws ReflectiveOperationException {
    Scene scene = TestScenes.read(file);
    for (int i = 0; i < 3; i++) {
      frames(new World(scene), 600);
    }
    World world = new World(scene);
    frames(world, WARM_UP);
    Meter meter = new Meter();
    assertThat(measured(meter, () -> frames(world, 600))).isEqualTo(measured(meter, () -> {}));
    assertThat(sum).isFinite();
  }

  /** The first two rungs: plain doubles, and a tie to 2e-16 that double-double decides. */
  @Test
  void queriesAllocateNothing() throws ReflectiveOperationException {
    SweptCircle[] down = new SweptCircle[12];
    Arrays.setAll(down, i -> new SweptCircle(5, 7 + i, 1, 0.25, -1));
    SweptCircle[] falling = new SweptCircle[12];
    Arrays.setAll(falling, i -> new SweptCircle(5, 7 + i, 1, 0.25, 2, 0, -1));
    SweptCircle[] others = new SweptCircle[100];
    Arrays.setAll(others, i -> new SweptCircle(9 + i, 0, 2, 0, 0));
    SweptCircle first = new SweptCircle(0, 0, 1, 1, 0.01);
    SweptCircle firstFalling = first.withAcceleration(0, -1);
    SweptCircle touching = new SweptCircle(5, TOUCHING, 1, 0, 1);
    SweptSphere sphere = new SweptSphere(0, 0, 0, 1, 1, 0, 0);
    SweptSphere[] spheres = new SweptSphere[100];
    Arrays.setAll(spheres, i -> new SweptSphere(9 + i, 0, 1, 2, 0, 0, 0));
    SweptSphere touchingSphere = new SweptSphere(0, 0, TOUCHING, 0, -1, -1, 1);
    Runnable queries =
        () -> {
          for (int i = 0; i < 20_000; i++) {
            sum += down[i % 12].timeToLine(0, 0, 10, 0, 1e6);
            sum += down[i % 12].timeToBounds(0, 0, 10, 30, 1e6);
            sum += down[i % 12].timeToPeg(6, 0, 2, 1e6) > 0 ? 1 : 0;
            sum += first.timeToCircle(others[i % 100], 1e6);
            sum += touching.timeToLine(0, 0, 10, 0, 1) > 0 ? 1 : 0;
            sum += touching.timeToPeg(5, 0, 0, 1) > 0 ? 1 : 0;
            sum += falling[i % 12].timeToLine(0, 0, 10, 0, 1e6);
            sum += falling[i % 12].timeToBounds(0, 0, 10, 30, 1e6);
            sum += firstFalling.timeToPeg(9 + i % 100, -5, 2, 1e6) > 0 ? 1 : 0;
            sum += firstFalling.timeToCircle(others[i % 100], 1e6) > 0 ? 1 : 0;
            sum += sphere.timeToSphere(spheres[i % 100], 1e6);
            sum += sphere.timeToSphere(touchingSphere, 1) > 0 ? 1 : 0;
          }
        };
    for (int i = 0; i < 20; i++) {
      queries.run();
    }
    Meter meter = new Meter();
    assertThat(measured(meter, queries)).isEqualTo(measured(meter, () -> {}));
    assertThat(sum).isFinite();
  }

  /** A cast allocates its answer; one that misses, nothing. */
  @Test
  void castsAllocateNoMoreThanTheirAnswers() throws ReflectiveOperationException {
    Line line = new Line(0, 0, 10, 0);
    Circle peg = new Circle(5, 0, 1);
    Bounds bounds = new Bounds(0, 0, 10, 30);
    SweptCircle other = new SweptCircle(peg, Vec2.ZERO);
    SweptCircle straight = new SweptCircle(5.1, 7, 1, 0.25, -1);
    for (SweptCircle circle : List.of(straight, straight.withAcceleration(0, -1))) {
      List<Supplier<Optional<Impact>>> casts =
          List.of(
              () -> circle.cast(line, 1e6),
              () -> circle.cast(line, Vec2.ZERO, 1e6),
              () -> circle.cast(peg, 1e6),
              () -> circle.cast(bounds, 1e6),
              () -> circle.cast(other, 1e6));
      for (int k = 0; k < casts.size(); k++) {
        Supplier<Optional<Impact>> cast = casts.get(k);
        Impact impact = cast.get().orElseThrow();
        long answer = ofMany(() -> Optional.of(copy(impact)));
        assertThat(ofMany(cast)).as("cast %s of %s", k, circle).isLessThanOrEqualTo(answer);
      }
      assertThat(ofMany(() -> circle.cast(line, 1))).isEqualTo(ofMany(Optional::empty));
    }
  }

  private static Impact copy(Impact i) {
    return new Impact(
        i.time(),
        i.circle(),
        i.kind(),
        i.id(),
        i.part(),
        i.feature(),
        i.x(),
        i.y(),
        i.nx(),
        i.ny(),
        i.approachSpeed(),
        i.impulse(),
        i.outcome());
  }

  /** The bytes of 20,000 answers, after many. */
  private long ofMany(Supplier<Optional<Impact>> cast) throws ReflectiveOperationException {
    Runnable many =
        () -> {
          for (int i = 0; i < 20_000; i++) {
            answer = cast.get();
          }
        };
    for (int i = 0; i < 20; i++) {
      many.run();
    }
    return measured(new Meter(), many);
  }

  /** Velocities set before each frame, sensors on the way, circles that collide or do not. */
  @CollidingOrNot
  void framesWithEditsAllocateNothing(boolean collide) throws ReflectiveOperationException {
    SceneBuilder builder = RandomScenes.responses(new Random(1)).collide(collide);
    World world = new World(builder.circle(400, 300, 30, 1, 2).response(Response.SENSOR).build());
    impacts = 0;
    Runnable frames =
        () -> {
          for (int frame = 0; frame < 200; frame++) {
            for (int id = 0; id < world.count(Kind.CIRCLE); id++) {
              // To and fro, so that all stay where they are, and none gets stuck.
              double way = frame % 20 < 10 ? 1 : -1;
              world.setVelocity(id, way * (id % 7 - 3.1), way * (id % 5 - 1.7));
            }
            world.step(1);
            read(world);
          }
        };
    for (int i = 0; i < 20; i++) {
      frames.run();
    }
    assertThat(impacts).isGreaterThan(1000);
    Meter meter = new Meter();
    assertThat(measured(meter, frames)).isEqualTo(measured(meter, () -> {}));
    assertThat(sum).isFinite();
  }

  /**
   * Two lines, two pegs and a circle that get a velocity or another place before each frame. The
   * lines lie below the bounds, where flights would meet them if they went on. For a falling circle
   * whose flight began where a line came to overlap it, exact numbers decide, which allocate.
   */
  @ParameterizedTest
  @CsvSource({"false, 0", "true, 0", "false, -0.01", "true, -0.01"})
  void framesWithMovedObstaclesAllocateNothing(boolean collide, double gravity)
      throws ReflectiveOperationException {
    Map<String, Edits> all =
        Map.of(
            "velocities", setVelocities(),
            "arrivals", moveTo(),
            "turns", turn(),
            "places", move(),
            "velocity of a circle", steerCircle(),
            "place of a circle", placeCircle());
    for (var each : all.entrySet()) {
      Edits edits = each.getValue();
      SceneBuilder builder = Scene.builder().collide(collide).bounds(0, 0, 800, 600);
      if (gravity != 0) {
        builder.gravity(0, gravity);
      }
      for (int i = 0; i < 2; i++) {
        builder.line(180 + 400 * i, -30, 200 + 400 * i, -29).peg(200 + 400 * i, 400, 10);
      }
      if (each.getKey().equals("arrivals") || each.getKey().equals("turns")) {
        builder.outline(Outline.rectangle(380, -40, 400, -20));
      }
      World world = new World(builder.circle(400.3, 100.7, 10, 4.1, 2.9).build());
      int[] frame = {0};
      Runnable frames =
          () -> {
            for (int k = 0; k < 2000; k++, frame[0]++) {
              edits.make(world, frame[0]);
              world.step(1);
              read(world);
            }
          };
      for (int i = 0; i < 20; i++) {
        frames.run();
      }
      Meter meter = new Meter();
      assertThat(measured(meter, frames)).as(each.getKey()).isEqualTo(measured(meter, () -> {}));
    }
    assertThat(sum).isFinite();
  }

  private interface Edits {
    void make(World world, int frame);
  }

  private static double toAndFro(int frame, double way) {
    return frame % 20 < 10 ? way : -way;
  }

  private static Edits setVelocities() {
    return (world, frame) -> {
      for (int id = 0; id < 2; id++) {
        world.setVelocity(Kind.PEG, id, toAndFro(frame, 0.1), toAndFro(frame + 5, 0.07));
        world.setVelocity(Kind.LINE, id, toAndFro(frame, 0.1), toAndFro(frame + 5, 0.07));
      }
    };
  }

  /** Each edit begins at the arrival that the one before asked for. */
  private static Edits moveTo() {
    return (world, frame) -> {
      for (int id = 0; id < 2; id++) {
        double x = 200 + 400 * id + 0.1 * (frame % 20);
        world.moveTo(Kind.PEG, id, x, 400 + 0.07 * (frame % 20), world.now() + 1);
        world.moveTo(Kind.LINE, id, x - 20, -30, world.now() + 1);
      }
      world.moveTo(Kind.LINE, 2, 380 + 0.1 * (frame % 20), -40, world.now() + 1); // an outline
    };
  }

  /** There and back, about points in and beside them. */
  private static Edits turn() {
    return (world, frame) -> {
      double angle = toAndFro(frame, 0.01);
      for (int id = 0; id < 2; id++) {
        world.turn(Kind.PEG, id, 200 + 400 * id, 380, angle, world.now() + 1);
        world.turn(Kind.LINE, id, 180 + 400 * id, -30, angle, world.now() + 1);
      }
      world.turn(Kind.LINE, 2, 400, -40, angle, world.now() + 1); // an outline
    };
  }

  /** The shapes are there before: an edit allocates nothing itself. */
  private static Edits move() {
    Circle[] pegs = new Circle[40];
    Line[] lines = new Line[40];
    for (int i = 0; i < 40; i++) {
      double x = 200 + 400 * (i / 20) + 0.1 * (i % 20);
      pegs[i] = new Circle(x, 400 + 0.07 * (i % 20), 10);
      lines[i] = new Line(x - 20, -30, x, -29);
    }
    return (world, frame) -> {
      for (int id = 0; id < 2; id++) {
        world.setShape(Kind.PEG, id, pegs[20 * id + frame % 20]);
        world.setShape(Kind.LINE, id, lines[20 * id + frame % 20]);
      }
    };
  }

  private static Edits steerCircle() {
    return (world, frame) -> world.setVelocity(0, toAndFro(frame, 4.1), toAndFro(frame + 5, 2.9));
  }

  private static Edits placeCircle() {
    return (world, frame) -> world.setPosition(0, 400.3 + frame % 20, 100.7 + (frame + 5) % 20);
  }

  /** Lines and pegs that move, slowly, so that they stay among the circles. */
  @CollidingOrNot
  void framesWithMovingObstaclesAllocateNothing(boolean collide)
      throws ReflectiveOperationException {
    Random random = new Random(3);
    SceneBuilder builder = Scene.builder().collide(collide).bounds(0, 0, 400, 300);
    for (int i = 0; i < 60; i++) {
      double x = 400 * random.nextDouble();
      double y = 300 * random.nextDouble();
      builder.line(x, y, x + 10 * random.nextGaussian(), y + 10 * random.nextGaussian());
      builder.velocity(0.001 * random.nextGaussian(), 0.001 * random.nextGaussian());
      builder.peg(400 * random.nextDouble(), 300 * random.nextDouble(), 3).velocity(0, 0.001);
      builder.circle(
          400 * random.nextDouble(), 300 * random.nextDouble(), 1, random.nextGaussian(), 1);
    }
    assertThatFramesAllocateNothing(new World(builder.build()));
  }

  /** Circles to and fro between walls: the past that is kept has as many flights at any time. */
  @CollidingOrNot
  void recordedFramesAllocateNothing(boolean collide) throws ReflectiveOperationException {
    SceneBuilder builder = Scene.builder().collide(collide).bounds(0, 0, 100, 100);
    for (int i = 0; i < 5; i++) {
      builder.circle(10 + 20 * i, 50, 5, 0, 60 + 10 * i);
    }
    World world = new World(builder.build());
    world.record(100);
    assertThatFramesAllocateNothing(world);
  }

  private void assertThatFramesAllocateNothing(World world) throws ReflectiveOperationException {
    frames(world, WARM_UP);
    impacts = 0;
    Meter meter = new Meter();
    assertThat(measured(meter, () -> frames(world, 200))).isEqualTo(measured(meter, () -> {}));
    assertThat(impacts).isGreaterThan(500);
    assertThat(sum).isFinite();
  }

  /** Balls that bounce, slide and rest under gravity. */
  @CollidingOrNot
  void framesWithGravityAllocateNothing(boolean collide) throws ReflectiveOperationException {
    Random random = new Random(3);
    SceneBuilder builder = Scene.builder().collide(collide).bounds(0, 0, 400, 300);
    builder.gravity(0, -0.25);
    for (int i = 0; i < 40; i++) {
      double x = 400 * random.nextDouble();
      double y = 20 + 200 * random.nextDouble();
      builder.line(x, y, x + 10 * random.nextGaussian(), y + 10 * random.nextGaussian());
      builder.peg(400 * random.nextDouble(), 20 + 200 * random.nextDouble(), 3);
      builder.circle(4 + 9 * i, 290, 1, random.nextGaussian(), 0);
    }
    for (int i = 0; i < 8; i++) { // on level floors of their own, on which they come to rest
      builder.line(10 + 40 * i, -100, 50 + 40 * i, -100);
      builder.circle(30 + 40 * i, -90, 1, 0.001, 0).restitution(0.5);
    }
    assertThatFramesAllocateNothing(new World(builder.build()));
  }

  /**
   * As much for a thousand casts as for one: what a call makes, and nothing for each cast. They are
   * so small that none overlaps two things at once: which is first would be decided exactly.
   */
  @CollidingOrNot
  void castsInBulkAllocateNothingEach(boolean collide) throws ReflectiveOperationException {
    Random random = new Random(1);
    SceneBuilder scene = Scene.builder().bounds(0, 0, 800, 600).collide(collide);
    for (int i = 0; i < 100; i++) {
      double x = 800 * random.nextDouble();
      double y = 600 * random.nextDouble();
      scene.line(x, y, x + 20 * random.nextDouble(), y - 20 * random.nextDouble());
      scene.peg(y, x, 2).velocity(i % 10 == 0 ? 0.1 : 0, 0);
      scene.circle(x, y, 3, random.nextGaussian(), random.nextGaussian());
    }
    World world = new World(scene.build());
    Resolver resolver = world.scene().resolver();
    Casts one = casts(random, 1);
    Casts many = casts(random, 1000);
    for (int i = 0; i < 300; i++) {
      world.cast(many, 1e3);
      resolver.cast(many, 1e3);
      world.cast(one, 1e3);
      resolver.cast(one, 1e3);
    }
    Meter meter = new Meter();
    assertThat(measured(meter, () -> world.cast(many, 1e3)))
        .isEqualTo(measured(meter, () -> world.cast(one, 1e3)));
    assertThat(measured(meter, () -> resolver.cast(many, 1e3)))
        .isEqualTo(measured(meter, () -> resolver.cast(one, 1e3)));
    assertThat(sum(many)).isFinite();
  }

  /** The impact that it returns, and an Optional. */
  @CollidingOrNot
  void aCastOfAWorldAllocatesItsAnswer(boolean collide) throws ReflectiveOperationException {
    World world =
        new World(
            Scene.builder()
                .bounds(0, 0, 99, 99)
                .collide(collide)
                .peg(50, 50, 5)
                .circle(20, 50, 3, 0, 0)
                .build());
    List<SweptCircle> asked =
        List.of(
            new SweptCircle(70, 50, 2, -1, 0),
            new SweptCircle(9, 50, 2, 1, 0),
            new SweptCircle(70, 50, 0, 1, 0));
    for (SweptCircle circle : asked) {
      assertThat(ofMany(() -> world.cast(circle, 1e3))).isLessThanOrEqualTo(150L * 20_000);
    }
  }

  @Test
  void traitsInALoopAllocateNothing() throws ReflectiveOperationException {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 99, 99);
    for (int i = 0; i < 8; i++) {
      scene.circle(10 * i, 9, 1, 1, 0).restitution(0.1 * i).mass(1 + i % 2);
      scene.line(10 * i, 50, 10 * i, 60).filter(new Filter(1 + i, -1));
    }
    World world = new World(scene.build());
    Runnable loop =
        () -> {
          for (int i = 0; i < 20_000; i++) {
            sum += world.traits(Kind.CIRCLE, i % 8).mass();
            sum += world.traits(Kind.LINE, i % 8).filter().category();
          }
        };
    loop.run();
    Meter meter = new Meter();
    assertThat(measured(meter, loop)).isEqualTo(measured(meter, () -> {}));
    assertThat(world.traits(Kind.CIRCLE, 3))
        .isEqualTo(Traits.DEFAULT.withMass(2).withRestitution(0.1 * 3));
  }

  private static Casts casts(Random random, int count) {
    Casts casts = new Casts();
    for (int i = 0; i < count; i++) {
      double x = 800 * random.nextDouble();
      double y = 600 * random.nextDouble();
      casts.add(x, y, i % 3 * 0.5, random.nextGaussian(), random.nextGaussian());
    }
    return casts;
  }

  private static double sum(Casts casts) {
    double sum = 0;
    for (int i = 0; i < casts.size(); i++) {
      sum += casts.hits(i) ? casts.time(i) + casts.nx(i) : 0;
    }
    return sum;
  }

  private static long measured(Meter meter, Runnable work) throws ReflectiveOperationException {
    long least = Long.MAX_VALUE;
    for (int i = 0; i < 3; i++) {
      long before = meter.bytes();
      work.run();
      least = Math.min(least, meter.bytes() - before);
    }
    return least;
  }

  private static void frames(World world, int count) {
    for (int i = 0; i < count; i++) {
      world.step(1);
      read(world);
    }
  }

  private static double sum;
  private static int impacts;

  private static void read(World world) {
    ImpactLog log = world.impacts();
    impacts += log.size();
    for (int row = 0; row < log.size(); row++) {
      sum += log.time(row) + log.x(row) + log.nx(row) + log.approachSpeed(row);
      sum += log.impulse(row);
      sum += log.kind(row) == Kind.WALL ? 1 : log.feature(row) == Feature.END ? 2 : 3;
    }
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      sum += world.x(i) + world.y(i) + world.vx(i) + world.vy(i);
    }
  }
}
