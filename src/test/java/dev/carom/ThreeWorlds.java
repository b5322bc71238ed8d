// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.state.EngineOptions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Random;
import java.util.function.Consumer;

/**
 * A world, a twin of it that finds impacts by other machinery in other steps, and a {@link
 * PlainWorld}: all are told the same, and must do the same. The twin also records its past. Beside
 * them goes a {@link RestoredTwin}, which has the same snapshots.
 */
final class ThreeWorlds {

  private static final EngineOptions[] OTHERS = {
    EngineOptions.EACH,
    EngineOptions.CHOSEN,
    new EngineOptions(true, 0, 4, 1),
    new EngineOptions(true, 3, 1.7, 1),
    new EngineOptions(true, 23, 2, 1)
  };

  private static final int IMPACTS = 5;

  /** Of the world: a step of more work than this ends a session anyway. */
  private static final long WORK = Run.WORK / 20;

  /** The source of random choices for the twin alone. */
  private final Random random;

  private final Scene scene;
  private final EngineOptions options;
  private World world;
  private World twin;
  private PastCheck past;
  private int compared;
  private final PlainWorld plain;
  private final RestoredTwin restored;

  /**
   * Makes the worlds of a scene.
   *
   * @param unit the unit of its lengths
   */
  ThreeWorlds(Scene scene, double unit, long seed) {
    this.scene = scene;
    random = new Random(seed);
    EngineOptions other = OTHERS[random.nextInt(OTHERS.length)];
    int slack = random.nextInt(2); // 0: its arrays are dense after each removal
    options = new EngineOptions(other.grid(), other.cell() * unit, other.pairCells(), slack);
    plain = new PlainWorld(scene);
    restored = new RestoredTwin(scene, options, new Random(seed + 1));
    begin();
  }

  private void begin() {
    world = new World(scene);
    twin = new World(scene, options);
    past = new PastCheck(twin);
  }

  /** The first of them, to look at. */
  World world() {
    return world;
  }

  // Steps.

  /**
   * Advances all three.
   *
   * @param most impacts: of more only the world itself knows
   * @return the number of impacts, -1 for more than that or unfinished
   */
  int advance(double end, int most) {
    double start = world.now();
    boolean arrives = plain.obstacles.nextArrival() == start;
    past.look();
    if (!world.advanceTo(end, WORK) || world.impacts().size() > most) {
      return -1;
    }
    List<Impact> rows = Run.rows(world.impacts());
    assertThat(advanceTwin(start, end, rows)).as("twin").isEqualTo(rows);
    assertThat(states(twin)).as("twin").isEqualTo(states(world));
    assertThat(Run.rows(plain.advance(end, rows.size() + 1))).as("plain").isEqualTo(rows);
    boolean complete = restored.advance(world, end, rows);
    assertThat(twin.snapshot()).as("snapshot of the twin").isEqualTo(world.snapshot());
    if (arrives || plain.firstEvent() == start) { // perhaps without a row
      past.forget(start);
    }
    past.look();
    ask();
    return complete ? rows.size() : -1;
  }

  /**
   * Asks for the first impact and for the path of one of the circles, or of a point in its place,
   * as if it began there.
   */
  private void ask() {
    int id = random.nextInt(world.idLimit(Kind.CIRCLE));
    if (!world.contains(Kind.CIRCLE, id) || !isWithinRange(id)) {
      return;
    }
    double radius = random.nextInt(3) == 0 ? 0 : world.radius(id);
    Circle circle = new Circle(world.x(id), world.y(id), radius);
    Vec2 v = new Vec2(world.vx(id), world.vy(id));
    int category = world.traits(Kind.CIRCLE, id).filter().category();
    int mask = world.traits(Kind.CIRCLE, id).filter().mask();
    double maxTime = Double.POSITIVE_INFINITY;
    Optional<Impact> first =
        world.withFilter(new Filter(category, mask)).cast(new SweptCircle(circle, v), maxTime);
    assertThat(
            twin.withFilter(new Filter(category, mask)).cast(new SweptCircle(circle, v), maxTime))
        .isEqualTo(first);
    double time = first.map(Impact::time).orElse(Double.POSITIVE_INFINITY);
    if (plain.obstacles.nextArrival() == Double.POSITIVE_INFINITY) { // else it would have to stop
      assertThat(plain.cast(circle, v, category, mask)).isEqualTo(time);
    }
    if (time < Double.MAX_VALUE / 8) {
      assertThat(
              twin.withFilter(new Filter(category, mask))
                  .trace(new SweptCircle(circle, v), 1, 8 * time, IMPACTS))
          .isEqualTo(
              world
                  .withFilter(new Filter(category, mask))
                  .trace(new SweptCircle(circle, v), 1, 8 * time, IMPACTS));
    }
  }

  private boolean isWithinRange(int id) {
    return Math.abs(world.x(id)) <= Double.MAX_VALUE && Math.abs(world.y(id)) <= Double.MAX_VALUE;
  }

  /** The same in up to four steps, some of which end at an impact, or an ulp from one. */
  private List<Impact> advanceTwin(double start, double end, List<Impact> rows) {
    double[] ends = new double[1 + random.nextInt(4)];
    for (int k = 0; k < ends.length; k++) {
      double drawn = start + (end - start) * random.nextDouble();
      double time = rows.isEmpty() ? drawn : rows.get(random.nextInt(rows.size())).time();
      double[] some = {drawn, Math.nextDown(time), time, Math.nextUp(time)};
      ends[k] = Math.max(start, Math.min(end, some[random.nextInt(some.length)]));
    }
    ends[0] = end;
    Arrays.sort(ends);
    List<Impact> inSteps = new ArrayList<>();
    for (double time : ends) {
      inSteps.addAll(Run.finish(twin, time, Run.WORK));
    }
    return inSteps;
  }

  private static List<Run.State> states(World world) {
    List<Run.State> states = new ArrayList<>();
    for (int i = 0; i < world.idLimit(Kind.CIRCLE); i++) {
      if (world.contains(Kind.CIRCLE, i)) {
        states.add(new Run.State(world.x(i), world.y(i), world.vx(i), world.vy(i)));
      }
    }
    return states;
  }

  // Edits.

  /** Makes an edit; if worlds refuse it, both do so in the same words, and the model is spared. */
  void edit(Consumer<World> edit, Consumer<PlainWorld> plainEdit) {
    restored.maybeFollow(world);
    String refusal = refusal(world, edit);
    assertThat(refusal(twin, edit)).isEqualTo(refusal);
    assertThat(refusal(restored.world(), edit)).isEqualTo(refusal);
    restored.compare(world);
    assertThat(twin.snapshot()).as("snapshot of the twin").isEqualTo(world.snapshot());
    if (Objects.isNull(refusal)) {
      plainEdit.accept(plain);
    }
  }

  private static String refusal(World world, Consumer<World> edit) {
    try {
      edit.accept(world);
      return null;
    } catch (IllegalArgumentException e) {
      return e.getMessage();
    }
  }

  // Snapshots.

  Snapshot snapshot() {
    return world.snapshot();
  }

  PlainWorld plainSnapshot() {
    return plain.copy();
  }

  /** Takes all three to where they were, some to new worlds. */
  void restore(Snapshot snapshot, PlainWorld plainSnapshot) {
    comparePast();
    if (random.nextBoolean()) {
      begin();
    }
    world.restore(snapshot);
    twin.restore(snapshot);
    plain.restore(plainSnapshot);
    past = new PastCheck(twin);
    assertThat(world.snapshot()).isEqualTo(snapshot);
    restored.follow(world);
  }

  /** Compares what the twin recorded with what was seen. */
  void comparePast() {
    compared += past.compare();
  }

  /** How many states of the past were compared. */
  int compared() {
    return compared;
  }
}
