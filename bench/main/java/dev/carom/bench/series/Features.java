// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.Filter;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Uncertainty;
import dev.carom.World;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.experiment.Gas;
import dev.carom.bench.experiment.SceneCopy;
import dev.carom.bench.experiment.Tiles;
import dev.carom.bench.measures.SceneRungs;
import dev.carom.bench.methods.RungCounts;
import dev.carom.bench.results.Row;
import java.lang.ref.Reference;
import java.util.ArrayList;
import java.util.List;

/**
 * The cost of each thing that a scene uses: the time of a frame and the memory of a world. The
 * canonical circles are played with ever more around them. The time is that of a whole replay,
 * divided by its frames; the memory is that of a world at the end of a replay.
 */
public final class Features {

  /** The metric of the times of a frame. */
  public static final String TIME = "feature_time";

  /** The metric of the memory of a world. */
  public static final String MEMORY = "feature_memory";

  /** The metric of the impacts of a frame. */
  public static final String IMPACTS = "feature_impacts";

  /** The prefix of the scenes' names. */
  public static final String SCENE = "feature:";

  private static final String METHOD = "carom";
  private static final int FRAMES = 600;
  private static final int WORLDS = 64;

  /** Of thousands of lines: each such world alone is large beside what else is on the heap. */
  private static final int LARGE_WORLDS = 8;

  private static final int MANY_LINES = 1000;
  private static final int RECORDED = 1_000_000;
  private static final int FEW_LINES = 8;
  private static final double GRAVITY = -0.05;

  /** Scenes of many circles play less long. */
  private static final int FEW_FRAMES = 60;

  /** 100 canonical scenes: 10,000 circles among as many lines. */
  private static final int TILES = 10;

  private static final int GAS = 1_000;
  private static final double PACKING = 0.2;

  /** The weight of the gas, from top to bottom of its box, is about its temperature. */
  private static final double GAS_GRAVITY = -0.01;

  /** An edit before each frame. */
  @FunctionalInterface
  private interface Action {
    void before(World world, int frame);
  }

  /** What is kept of a world besides its present state. */
  private enum Keep {
    NOTHING,
    PAST,
    ERRORS
  }

  private record Use(String name, Scene scene, int frames, Keep keep, Action action) {

    Use(String name, Scene scene) {
      this(name, scene, Keep.NOTHING, (world, frame) -> {});
    }

    Use(String name, Scene scene, Keep keep, Action action) {
      this(name, scene, FRAMES, keep, action);
    }

    /** How many worlds tell the memory of one. */
    int worlds() {
      return scene.count(Kind.LINE) > MANY_LINES ? LARGE_WORLDS : WORLDS;
    }

    /** Returns what holds the world at the end, and all that is kept of it. */
    Object play(int[] impacts) {
      World world = new World(scene);
      if (keep == Keep.PAST) {
        world.record(RECORDED);
      }
      Uncertainty uncertainty = keep == Keep.ERRORS ? world.uncertainty(1) : null;
      for (int frame = 0; frame < frames; frame++) {
        action.before(world, frame);
        world.step(1);
        impacts[0] += world.impacts().size();
      }
      return uncertainty == null ? world : uncertainty;
    }
  }

  private final List<Use> uses = new ArrayList<>();
  private final Turns turns;

  /**
   * Prepares the scenes.
   *
   * @param seed of the canonical scene
   * @param turns seed of the order in which the scenes take turns
   * @throws CannotPlaceException if the canonical scene of this seed has no room
   */
  public Features(long seed, long turns) throws CannotPlaceException {
    this.turns = new Turns(turns);
    Scene canonical = Crosses.canonical(seed).scene();
    uses.add(
        new Use("circles", SceneCopy.circles(Scene.builder().collide(false), canonical).build()));
    uses.add(new Use("walls", part(canonical, 0, Response.BOUNCE)));
    uses.add(new Use("few-lines", part(canonical, FEW_LINES, Response.BOUNCE)));
    uses.add(new Use("lines", canonical));
    int all = canonical.count(Kind.LINE);
    uses.add(new Use("sensors", part(canonical, all, Response.SENSOR)));
    uses.add(new Use("masks", masked(canonical)));
    uses.add(new Use("recording", canonical, Keep.PAST, (world, frame) -> {}));
    uses.add(new Use("uncertainty", canonical, Keep.ERRORS, (world, frame) -> {}));
    uses.add(new Use("steering", canonical, Keep.NOTHING, Features::steer));
    uses.add(new Use("moving-line", canonical, Keep.NOTHING, Features::move));
    uses.add(
        new Use(
            "collisions",
            SceneCopy.circles(SceneCopy.bounds(canonical).collide(true), canonical).build()));
    uses.add(new Use("many-lines", AmongMovingLines.scene(seed, FRAMES, false)));
    uses.add(new Use("moving-lines", AmongMovingLines.scene(seed, FRAMES, true)));
    uses.add(new Use("gravity", falling(canonical, GRAVITY)));
    Scene tiles = new Tiles(TILES, true, seed).scene();
    uses.add(many("tiles", tiles));
    uses.add(many("falling-tiles", falling(tiles, GRAVITY)));
    Scene gas = new Gas(GAS, PACKING, 1, false, seed).scene();
    uses.add(many("gas", gas));
    uses.add(many("falling-gas", falling(gas, GAS_GRAVITY)));
  }

  private static Use many(String name, Scene scene) {
    return new Use(name, scene, FEW_FRAMES, Keep.NOTHING, (world, frame) -> {});
  }

  /** The same circles and lines under gravity. */
  private static Scene falling(Scene whole, double gravity) {
    return SceneCopy.circles(SceneCopy.obstacles(whole).gravity(0, gravity), whole).build();
  }

  /** With the walls, and so many of the lines. */
  private static Scene part(Scene whole, int lines, Response response) {
    SceneBuilder builder = SceneCopy.bounds(whole);
    for (int k = 0; k < lines; k++) {
      SceneCopy.line(builder, (Line) whole.shape(Kind.LINE, k)).response(response);
    }
    return SceneCopy.circles(builder, whole).build();
  }

  /** Two layers: each line, and each circle, is in one of them. */
  private static Scene masked(Scene whole) {
    SceneBuilder builder = SceneCopy.bounds(whole);
    for (int k = 0; k < whole.count(Kind.LINE); k++) {
      SceneCopy.line(builder, (Line) whole.shape(Kind.LINE, k))
          .filter(new Filter(layer(k), layer(k) | 1));
    }
    for (int i = 0; i < whole.count(Kind.CIRCLE); i++) {
      SceneCopy.circle(builder, whole, i).filter(new Filter(layer(i), layer(i) | 1));
    }
    return builder.build();
  }

  private static int layer(int i) {
    return 2 << i % 2;
  }

  /** One circle a frame gets the opposite velocity. */
  private static void steer(World world, int frame) {
    int circle = frame % world.count(Kind.CIRCLE);
    world.setVelocity(circle, -world.vx(circle), -world.vy(circle));
  }

  /** One line goes to and fro. */
  private static void move(World world, int frame) {
    Line line = world.line(0);
    int way = frame % 2 == 0 ? 1 : -1;
    world.setShape(Kind.LINE, 0, new Line(line.ax() + way, line.ay(), line.bx() + way, line.by()));
  }

  /**
   * Measures.
   *
   * @param rounds in which the scenes take turns
   * @param warmUpMillis how long they do before anything is measured
   * @param memory whether memory is measured, too
   */
  public List<Row> run(int rounds, int warmUpMillis, boolean memory) {
    List<Row> rows = new ArrayList<>();
    if (memory) {
      uses.stream()
          .filter(use -> use.frames == FRAMES)
          .forEach(use -> rows.add(row(use, MEMORY, "mean", bytes(use), "bytes", use.worlds())));
    }
    Turns.warmUp(warmUpMillis, () -> uses.forEach(use -> use.play(new int[1])));
    turns.rounds(rounds, uses, Features::timed).forEach((use, times) -> add(rows, use, times));
    return rows;
  }

  /**
   * Plays each scene once, and counts how often it needs more precision.
   *
   * @param progress called after each scene
   */
  public List<SceneRungs> rungs(Runnable progress) {
    List<SceneRungs> counts = new ArrayList<>();
    for (Use use : uses) {
      RungCounts before = RungCounts.now();
      use.play(new int[1]);
      counts.add(new SceneRungs(SCENE + use.name, RungCounts.now().since(before)));
      progress.run();
    }
    return counts;
  }

  /** The number of scenes. */
  public int size() {
    return uses.size();
  }

  /** Nanoseconds of a frame, and impacts of all. */
  private record Time(double nanos, int impacts) {}

  private static Time timed(Use use) {
    int[] impacts = new int[1];
    long start = System.nanoTime();
    use.play(impacts);
    return new Time((double) (System.nanoTime() - start) / use.frames, impacts[0]);
  }

  private static void add(List<Row> rows, Use use, List<Time> times) {
    double median = SeriesRows.median(times.stream().mapToDouble(Time::nanos).toArray());
    rows.add(row(use, TIME, "median", median, "ns", (long) times.size() * use.frames));
    double mean = (double) times.get(0).impacts / use.frames;
    rows.add(row(use, IMPACTS, "mean", mean, "1", use.frames));
  }

  private static Row row(Use use, String metric, String stat, double value, String unit, long n) {
    return new Row(SCENE + use.name, METHOD, "", metric, stat, value, unit, n, 0);
  }

  /** Many worlds, for one alone is small beside what else comes and goes on the heap. */
  private static double bytes(Use use) {
    use.play(new int[1]);
    long before = Footprint.used();
    Object[] worlds = new Object[use.worlds()];
    for (int i = 0; i < worlds.length; i++) {
      worlds[i] = use.play(new int[1]);
    }
    try {
      return Math.max(0, (double) (Footprint.used() - before) / worlds.length);
    } finally {
      Reference.reachabilityFence(worlds);
    }
  }
}
