// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import dev.carom.internal.exact.PrecisionCounter;
import dev.carom.internal.state.EngineOptions;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The answers of indexes beside those of a loop that asks each obstacle and each circle: the same
 * to the bit. {@code -Dcarom.questions=600} asks more between two edits.
 */
@Tag("long")
class QuestionsTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** So many questions between two edits or steps: the later ones use an index. */
  private static final int QUESTIONS = Integer.getInteger("carom.questions", 8);

  /** Coordinates: mostly in a field of 100, some on a lattice, a few far away. */
  private static double place(Random random, double unit) {
    double place = random.nextBoolean() ? random.nextInt(100) : 100 * random.nextDouble();
    return (random.nextInt(200) == 0 ? 1e4 * place : place) * unit;
  }

  /** Lengths: mostly short, some zero, some long. */
  private static double way(Random random, double unit) {
    int kind = random.nextInt(10);
    return (kind == 0 ? 0 : (kind == 1 ? 60 : 6) * (random.nextDouble() - 0.5)) * unit;
  }

  private static double radius(Random random, double unit) {
    return unit * Math.scalb(random.nextDouble(), 3 - random.nextInt(8));
  }

  private static Scene scene(Random random, double unit, boolean collide, boolean bounds) {
    SceneBuilder scene = Scene.builder().collide(collide);
    if (bounds) {
      scene.bounds(-2e6 * unit, -2e6 * unit, 2e6 * unit, 2e6 * unit);
    }
    for (int i = 0; i < 150; i++) {
      double x = place(random, unit);
      double y = place(random, unit);
      scene.line(x, y, x + way(random, unit), y + way(random, unit));
      if (random.nextInt(20) == 0) {
        scene.response(Response.SENSOR);
      } else if (random.nextInt(10) == 0) {
        scene.oneWay();
      }
      if (random.nextInt(15) == 0) {
        scene.velocity(speed(random, unit), speed(random, unit));
      } else if (random.nextInt(10) == 0) {
        scene.filter(new Filter(2, -1));
      }
    }
    scene.line(3 * unit, 3 * unit, 9 * unit, 9 * unit).line(3 * unit, 3 * unit, 9 * unit, 9 * unit);
    for (int i = 0; i < 40; i++) {
      double r = random.nextInt(8) == 0 ? 0 : radius(random, unit);
      scene.peg(place(random, unit), place(random, unit), r);
    }
    return scene.build();
  }

  private static void addCircles(World world, Random random, double unit, int count) {
    for (int i = 0; i < count; i++) {
      double r = unit * (0.1 + random.nextDouble());
      int id =
          world.addCircle(
              place(random, unit),
              place(random, unit),
              r,
              speed(random, unit),
              speed(random, unit),
              Traits.DEFAULT);
      if (i % 9 == 0) {
        world.setTraits(
            Kind.CIRCLE, id, world.traits(Kind.CIRCLE, id).withResponse(Response.SENSOR));
      }
    }
  }

  private static double speed(Random random, double unit) {
    return random.nextInt(8) == 0 ? 0 : random.nextGaussian() * unit;
  }

  /** Two worlds of one scene; the second one uses no index. */
  private record Twins(World indexed, World plain) {

    static Twins of(Scene scene) {
      return new Twins(new World(scene), new World(scene, EngineOptions.EACH));
    }

    /** Does the same with both. */
    void each(Consumer<World> edit) {
      edit.accept(indexed);
      edit.accept(plain);
    }

    /** Asks both. */
    <T> T compare(Function<World, T> question) {
      T answer = question.apply(indexed);
      assertThat(answer).isEqualTo(question.apply(plain));
      return answer;
    }
  }

  /** Circles that fall, among some that do not, since their masses are infinite. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 1e-70, 1e70})
  void worldsWithGravityAnswerAsALoopDoes(double unit) {
    for (int seed = 0; seed < 2; seed++) {
      Random random = new Random(seed);
      Twins worlds = Twins.of(scene(random, unit, true, seed == 0));
      Random circles = new Random(seed);
      worlds.each(world -> world.setGravity(0.1 * unit, -0.2 * unit));
      for (int i = 0; i < 100; i++) {
        double mass = circles.nextInt(4) == 0 ? NEVER : 1;
        double x = place(circles, unit);
        double y = place(circles, unit);
        double r = unit * (0.1 + circles.nextDouble());
        double vx = speed(circles, unit);
        double vy = speed(circles, unit);
        worlds.each(world -> world.addCircle(x, y, r, vx, vy, Traits.DEFAULT.withMass(mass)));
      }
      for (int round = 0; round < 3; round++) {
        for (int i = 0; i < QUESTIONS; i++) {
          askForFirst(worlds, random, unit);
        }
        double turn = round;
        worlds.each(world -> world.setGravity(0.2 * unit, (turn - 0.5) * unit));
        if (unit == 1) { // of other units a step may be unfinished, and then the worlds differ
          worlds.each(world -> world.step(0.3));
        }
      }
    }
  }

  /** Casts as they are, until their impact, and with a speed far from those of the circles. */
  private static void askForFirst(Twins worlds, Random random, double unit) {
    double x = place(random, unit);
    double y = place(random, unit);
    Circle disk = new Circle(x, y, random.nextInt(3) == 0 ? 0 : radius(random, unit));
    double factor = Math.scalb(1.0, random.nextInt(20) - 10);
    Vec2 v = new Vec2(factor * speed(random, unit), factor * speed(random, unit));
    double maxTime = random.nextInt(3) == 0 ? NEVER : 40 * random.nextDouble();
    double gy = random.nextInt(3) == 0 ? -unit : 0;
    SweptCircle asked = new SweptCircle(disk, v).withAcceleration(0, gy);
    Optional<Impact> hit = worlds.compare(world -> world.cast(asked, maxTime));
    hit.ifPresent(impact -> worlds.compare(world -> world.cast(asked, impact.time())));
    worlds.compare(world -> world.withFilter(new Filter(1, 1)).cast(asked, maxTime));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1e-160, 1e140, 1e250})
  void worldsAnswerAsALoopDoes(double unit) {
    for (int seed = 0; seed < (unit == 1 ? 6 : 2); seed++) {
      Random random = new Random(seed);
      Twins worlds = Twins.of(scene(random, unit, seed % 2 == 1, seed % 4 < 2));
      long circles = seed;
      int count = seed % 3 == 0 ? 0 : 120;
      worlds.each(world -> addCircles(world, new Random(circles), unit, count));
      for (int round = 0; round < (unit == 1 ? 6 : 4); round++) {
        for (int i = 0; i < QUESTIONS; i++) {
          ask(worlds, random, unit);
        }
        int edits = round;
        worlds.each(world -> edit(world, new Random(edits), unit, edits));
        worlds.each(world -> goOn(world, edits % 2 == 0 ? 0 : 0.3));
      }
    }
  }

  /** A crowd need not get to the end: questions are about where it stands. */
  private static void goOn(World world, double dt) {
    world.advanceTo(world.now() + dt, Run.work(world, 1_000));
  }

  private static void edit(World world, Random random, double unit, int round) {
    int[] lines = world.ids(Kind.LINE);
    int[] pegs = world.ids(Kind.PEG);
    for (int i = 0; i < (round == 3 ? 60 : 4); i++) {
      double x = place(random, unit);
      double y = place(random, unit);
      world.setShape(
          Kind.LINE, lines[i], new Line(x, y, x + way(random, unit), y + way(random, unit)));
      world.addLine(y, x, x, y, Traits.DEFAULT);
    }
    world.remove(Kind.LINE, lines[lines.length / 2]);
    world.remove(Kind.PEG, pegs[round]);
    world.setShape(
        Kind.PEG,
        pegs[9],
        new Circle(place(random, unit), place(random, unit), radius(random, unit)));
    world.addPeg(place(random, unit), place(random, unit), radius(random, unit), Traits.DEFAULT);
    world.setVelocity(Kind.PEG, pegs[10 + round], speed(random, unit), unit);
    world.setVelocity(Kind.LINE, lines[10], 0, 0);
    world.setTraits(Kind.PEG, pegs[20 + round], Traits.DEFAULT.withFilter(new Filter(2, 4)));
    int[] circles = world.ids(Kind.CIRCLE);
    if (circles.length > 0) {
      world.remove(Kind.CIRCLE, circles[round]);
      world.setPosition(circles[19], place(random, unit), place(random, unit));
      world.setVelocity(circles[21], 50 * unit, unit);
      int circle = circles[22];
      Traits filtered = world.traits(Kind.CIRCLE, circle).withFilter(new Filter(2, -1));
      world.setTraits(Kind.CIRCLE, circle, filtered);
      addCircles(world, random, unit, 3);
    }
  }

  private static void ask(Twins worlds, Random random, double unit) {
    double x = place(random, unit);
    double y = place(random, unit);
    double r = random.nextInt(3) == 0 ? 0 : radius(random, unit);
    Line line = worlds.plain.line(worlds.plain.ids(Kind.LINE)[random.nextInt(100)]);
    Circle disk =
        random.nextInt(6) == 0 ? new Circle(line.ax() + r, line.ay(), r) : new Circle(x, y, r);
    Vec2 v = new Vec2(speed(random, unit), speed(random, unit));
    double maxTime = random.nextInt(3) == 0 ? NEVER : 40 * random.nextDouble();
    Optional<Impact> hit = worlds.compare(world -> world.cast(new SweptCircle(disk, v), maxTime));
    hit.ifPresent(
        impact -> worlds.compare(world -> world.cast(new SweptCircle(disk, v), impact.time())));
    worlds.compare(world -> world.trace(new SweptCircle(disk, v), 0.9, 30, 12));
    Bounds box = new Bounds(x - 3 * unit, y - 5 * unit, x + random.nextDouble() * unit, y + unit);
    for (Kind kind : Kind.values()) {
      worlds.compare(world -> world.nearest(x, y, kind).map(Nearest::id).orElse(-1));
      worlds.compare(world -> list(world.overlapping(kind, disk)));
      worlds.compare(world -> list(world.overlapping(kind, box)));
      worlds.compare(
          world ->
              world.withFilter(new Filter(4, 2)).nearest(x, y, kind).map(Nearest::id).orElse(-1));
      worlds.compare(world -> list(world.withFilter(new Filter(1, 1)).overlapping(kind, disk)));
      worlds.compare(world -> list(world.withFilter(new Filter(4, 2)).overlapping(kind, box)));
    }
    worlds.compare(
        world -> world.withFilter(new Filter(1, 1)).cast(new SweptCircle(disk, v), maxTime));
    worlds.compare(
        world -> world.withFilter(new Filter(4, 2)).trace(new SweptCircle(disk, v), 0.9, 30, 12));
  }

  private static List<Integer> list(int[] ids) {
    return IntStream.of(ids).boxed().collect(Collectors.toList());
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1e-160, 1e140, 1e250})
  void resolversAnswerAsALoopDoes(double unit) {
    for (int seed = 0; seed < (unit == 1 ? 4 : 1); seed++) {
      Random random = new Random(seed);
      Scene scene = scene(random, unit, false, seed % 2 == 0);
      Resolver resolver = scene.resolver();
      for (int i = 0; i < 100 + 6 * QUESTIONS; i++) {
        double x = place(random, unit);
        double y = place(random, unit);
        Circle disk = new Circle(x, y, i % 3 == 0 ? 0 : radius(random, unit));
        Vec2 v = new Vec2(speed(random, unit), speed(random, unit));
        Bounds box = new Bounds(x, y - 5 * unit, x + 9 * random.nextDouble() * unit, y + unit);
        Resolver plain = scene.resolver(); // too few questions for an index
        assertThat(resolver.cast(new SweptCircle(disk, v), 9))
            .isEqualTo(plain.cast(new SweptCircle(disk, v), 9));
        SweptCircle falling =
            new SweptCircle(disk, v).withAcceleration(speed(random, unit), speed(random, unit));
        if (unit == 1 || i % 5 == 0) { // without an index, exact numbers decide most of these
          assertThat(resolver.cast(falling, 9)).isEqualTo(plain.cast(falling, 9));
        }
        assertThat(resolver.trace(new SweptCircle(disk, v), 1, 9, 12))
            .isEqualTo(plain.trace(new SweptCircle(disk, v), 1, 9, 12));
        assertThat(resolver.nearest(x, y)).isEqualTo(plain.nearest(x, y));
        for (Kind kind : Kind.values()) {
          assertThat(resolver.overlapping(kind, disk)).isEqualTo(plain.overlapping(kind, disk));
          assertThat(resolver.overlapping(kind, box)).isEqualTo(plain.overlapping(kind, box));
        }
      }
    }
  }

  /** A cast among many falling circles asks only those that are near its path. */
  @Test
  void aCastLooksAtFewFallingCircles() {
    Random random = new Random(1);
    SceneBuilder scene = Scene.builder().bounds(0, 0, 500, 500).gravity(0, -0.05);
    for (int i = 0; i < 2_500; i++) {
      double x = 5 + 10 * (i % 50);
      double y = 5 + 10 * (i / 50);
      scene.circle(x, y, 3, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1);
    }
    World world = new World(scene.build());
    world.step(3);
    long before = 0;
    int casts = 200;
    for (int i = -20; i < casts; i++) {
      if (i == 0) { // now there is an index
        before = PrecisionCounter.PARABOLAS.count();
      }
      Circle ray = new Circle(500 * random.nextDouble(), 500 * random.nextDouble(), 0);
      world.cast(
          new SweptCircle(ray, new Vec2(random.nextGaussian(), random.nextGaussian())), NEVER);
    }
    assertThat(PrecisionCounter.PARABOLAS.count() - before).isLessThan(200L * casts);
  }

  @Test
  void aCastThatIsNotThereIsNamed() {
    Casts casts = new Casts();
    assertThatExceptionOfType(IndexOutOfBoundsException.class)
        .isThrownBy(() -> casts.time(0))
        .withMessage("cast is 0: expected none, there are no casts");
    casts.add(0, 0, 1, 1, 0);
    casts.add(0, 0, 1, 1, 0);
    assertThat(casts.hits(1)).isFalse();
    for (int i : new int[] {-1, 2}) {
      assertThatExceptionOfType(IndexOutOfBoundsException.class)
          .isThrownBy(() -> casts.kind(i))
          .withMessage("cast is " + i + ": expected 0 to 1");
      assertThatExceptionOfType(IndexOutOfBoundsException.class)
          .isThrownBy(() -> casts.set(i, 0, 0, 1, 1, 0))
          .withMessage("cast is " + i + ": expected 0 to 1");
    }
  }

  /** Casts in bulk and one by one. */
  @CollidingOrNot
  void manyCastsInOneCallAreAnsweredAsOneByOne(boolean collide) {
    Random random = new Random(1);
    Scene scene = scene(random, 1, collide, true);
    World world = new World(scene);
    addCircles(world, random, 1, 90);
    Resolver resolver = scene.resolver();
    Casts casts = new Casts();
    for (int round = 0; round < 3; round++) {
      List<Optional<Impact>> ofWorld = new ArrayList<>();
      List<Optional<Impact>> ofResolver = new ArrayList<>();
      casts.clear();
      for (int i = 0; i < 300; i++) {
        Circle disk = new Circle(place(random, 1), place(random, 1), i % 2 * radius(random, 1));
        Vec2 v = new Vec2(speed(random, 1), speed(random, 1));
        assertThat(casts.add(disk.x(), disk.y(), disk.radius(), v.x(), v.y())).isEqualTo(i);
        ofWorld.add(world.cast(new SweptCircle(disk, v), 15));
        ofResolver.add(resolver.cast(new SweptCircle(disk, v), 15));
      }
      world.cast(casts, 15);
      assertAnswers(casts, ofWorld);
      resolver.cast(casts, 15);
      assertAnswers(casts, ofResolver);
      world.step(0.5);
    }
  }

  private static void assertAnswers(Casts casts, List<Optional<Impact>> expected) {
    assertThat(casts.size()).isEqualTo(expected.size());
    for (int i = 0; i < casts.size(); i++) {
      Optional<Impact> hit = expected.get(i);
      assertThat(casts.hits(i)).isEqualTo(hit.isPresent());
      assertThat(casts.time(i)).isEqualTo(hit.map(Impact::time).orElse(NEVER));
      assertThat(casts.id(i)).isEqualTo(hit.map(Impact::id).orElse(-1));
      if (hit.isPresent()) {
        assertThat(casts.kind(i)).isEqualTo(hit.get().kind());
        assertThat(casts.feature(i)).isEqualTo(hit.get().feature());
      }
      Vec2 normal = hit.map(Impact::normal).orElse(new Vec2(0, 0));
      assertThat(new Vec2(casts.nx(i), casts.ny(i))).isEqualTo(normal);
    }
  }

  @Test
  void badCastsAreRefusedWithNothingWritten() {
    Casts casts = new Casts();
    casts.add(0, 0, 1, 1, 0);
    Resolver resolver = Resolver.of(List.of(new Line(5, -5, 5, 5)));
    resolver.cast(casts, 10);
    assertThat(casts.time(0)).isEqualTo(4);
    double nan = Double.NaN;
    double[][] bad = {
      {nan, 0, 1, 1, 0}, {0, NEVER, 1, 1, 0}, {0, 0, -1, 1, 0}, {0, 0, 1, nan, 0}, {0, 0, 1, 1, nan}
    };
    String[] names = {"x", "y", "radius", "vx", "vy"};
    for (int k = 0; k < bad.length; k++) {
      double[] b = bad[k];
      assertThatIllegalArgumentException()
          .isThrownBy(() -> casts.add(b[0], b[1], b[2], b[3], b[4]))
          .withMessageStartingWith(names[k] + " is " + b[k]);
      assertThatIllegalArgumentException()
          .isThrownBy(() -> casts.set(0, b[0], b[1], b[2], b[3], b[4]))
          .withMessageStartingWith(names[k] + " is " + b[k]);
    }
    World world = new World(Scene.builder().bounds(-1, -1, 1, 1).build());
    for (double t : new double[] {nan, -1}) {
      assertThatIllegalArgumentException().isThrownBy(() -> resolver.cast(casts, t));
      assertThatIllegalArgumentException().isThrownBy(() -> world.cast(casts, t));
    }
    assertThat(casts.size()).isEqualTo(1);
    assertThat(casts.time(0)).isEqualTo(4);
    assertThatExceptionOfType(IndexOutOfBoundsException.class).isThrownBy(() -> casts.time(1));
    assertThatExceptionOfType(IndexOutOfBoundsException.class)
        .isThrownBy(() -> casts.set(1, 0, 0, 0, 1, 0));
    casts.set(0, 0, 0, 2, 1, 0);
    assertThat(casts.hits(0)).as("a new cast has no answer yet").isFalse();
  }

  /** All ask one resolver at once, while it makes its indexes. */
  @Test
  void threadsShareAResolver() throws InterruptedException, ExecutionException {
    ExecutorService threads = Executors.newFixedThreadPool(4);
    try {
      for (int seed = 0; seed < 8; seed++) {
        Resolver resolver = scene(new Random(seed), 1, false, true).resolver();
        List<Optional<Impact>> expected = casts(resolver);
        Resolver shared = scene(new Random(seed), 1, false, true).resolver();
        List<Future<List<Optional<Impact>>>> answers = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
          answers.add(threads.submit(() -> casts(shared)));
        }
        for (Future<List<Optional<Impact>>> answer : answers) {
          assertThat(answer.get()).isEqualTo(expected);
        }
      }
    } finally {
      threads.shutdown();
    }
  }

  private static List<Optional<Impact>> casts(Resolver resolver) {
    Random random = new Random(1);
    List<Optional<Impact>> hits = new ArrayList<>();
    for (int i = 0; i < 200; i++) {
      Circle circle = new Circle(place(random, 1), place(random, 1), radius(random, 1));
      hits.add(
          resolver.cast(new SweptCircle(circle, new Vec2(speed(random, 1), speed(random, 1))), 50));
    }
    return hits;
  }
}
