// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.function.Consumer;

/**
 * Edits, steps, snapshots and restores in random order, done to a world, to a twin of it that finds
 * impacts by other machinery in other steps, and to a {@link PlainWorld}: what happens is the same
 * in all three.
 */
final class EditSession {

  private static final Machinery[] OTHERS = {
    Machinery.EACH,
    Machinery.CHOSEN,
    new Machinery(true, 0, 4),
    new Machinery(true, 3, 1.7),
    new Machinery(true, 23, 2)
  };

  private final Random random;

  /** What is drawn for the twin alone. */
  private final Random aside;

  private final SessionNumbers numbers;
  private final int length;
  private final int mostImpacts;
  private final boolean sensors;
  private final Scene scene;
  private final Machinery machinery;
  private World world;
  private World twin;
  private final PlainWorld plain;
  private final List<Snapshot> snapshots = new ArrayList<>();
  private final List<PlainWorld> plainSnapshots = new ArrayList<>();
  private int impacts;
  private int done;

  /** A circle is in a corridor that is hardly wider than itself: too much for the model. */
  private boolean stuck;

  /**
   * A session.
   *
   * @param hard whether its numbers are {@link SessionNumbers.Hard}
   * @param length how many edits it has at most
   * @param mostImpacts a step of more ends it: the model would take minutes
   */
  EditSession(long seed, boolean collide, boolean hard, int length, int mostImpacts) {
    random = new Random(seed);
    aside = new Random(~seed);
    this.length = length;
    this.mostImpacts = mostImpacts;
    numbers = hard ? new SessionNumbers.Hard(random) : new SessionNumbers(random);
    sensors = random.nextBoolean();
    scene = scene(collide, hard);
    Machinery other = OTHERS[aside.nextInt(OTHERS.length)];
    machinery = new Machinery(other.grid(), other.cell() * numbers.length(), other.pairCells());
    world = new World(scene);
    twin = new World(scene, machinery);
    plain = new PlainWorld(scene);
  }

  private Scene scene(boolean collide, boolean hard) {
    SceneBuilder builder = Scene.builder().collide(collide);
    if (!hard || random.nextInt(4) > 0) {
      double least = numbers.origin();
      double width = SessionNumbers.WIDTH * numbers.length();
      double height = SessionNumbers.HEIGHT * numbers.length();
      builder.bounds(least, least, least + width, least + height);
    }
    for (int i = random.nextInt(12); i > 0; i--) {
      builder.line(numbers.x(), numbers.y(), numbers.x(), numbers.y());
    }
    for (int i = random.nextInt(3); i > 0; i--) {
      builder.peg(numbers.x(), numbers.y(), numbers.pegRadius());
    }
    boolean waits = numbers.begin() > 0;
    for (int i = numbers.circles(); i > 0; i--) {
      builder.circle(numbers.x(), numbers.y(), numbers.radius(), speed(waits), speed(waits));
    }
    return builder.build();
  }

  private double speed(boolean waits) {
    return waits ? 0 : numbers.speed();
  }

  /** Edits, steps, snapshots and restores so far. */
  int done() {
    return done;
  }

  boolean isStuck() {
    return stuck;
  }

  /** Plays it to its end, and returns the number of impacts. */
  int run() throws IOException {
    begin();
    while (done < length && !stuck) {
      act(random.nextInt(20));
      done++;
    }
    return impacts;
  }

  private void begin() {
    if (numbers.begin() > 0) {
      advance(numbers.begin());
      for (int id = 0; id < scene.circleCount(); id++) {
        setVelocity(id);
      }
    }
  }

  private void act(int what) throws IOException {
    switch (what) {
      case 0, 1, 2 -> step(numbers.duration(2, false));
      case 3 -> step(numbers.duration(1, true));
      case 4, 5 -> setMotion();
      case 6 -> setProperties();
      case 7 -> addCircle();
      case 8 -> addObstacle();
      case 9, 10 -> moveObstacle();
      case 11 -> remove();
      case 12 -> setTraits();
      case 13 -> snapshot();
      case 14 -> restore();
      default -> step(numbers.duration(0.25, false));
    }
  }

  // Steps.

  private void step(double dt) {
    advance(world.now() + dt);
  }

  private void advance(double end) {
    double start = world.now();
    if (!world.advanceTo(end) || world.impacts().size() > mostImpacts) {
      stuck = true;
      return;
    }
    List<Run.Row> rows = Run.rows(world.impacts());
    assertThat(advanceTwin(start, end, rows)).as("twin").isEqualTo(rows);
    assertThat(states(twin)).as("twin").isEqualTo(states(world));
    assertThat(Run.rows(plain.advance(end, rows.size() + 1))).as("plain").isEqualTo(rows);
    impacts += rows.size();
  }

  /** The same in up to four steps, some of which end at an impact, or an ulp from one. */
  private List<Run.Row> advanceTwin(double start, double end, List<Run.Row> rows) {
    double[] ends = new double[1 + aside.nextInt(4)];
    for (int k = 0; k < ends.length; k++) {
      double drawn = start + (end - start) * aside.nextDouble();
      double time = rows.isEmpty() ? drawn : rows.get(aside.nextInt(rows.size())).time();
      double[] some = {drawn, Math.nextDown(time), time, Math.nextUp(time)};
      ends[k] = Math.max(start, Math.min(end, some[aside.nextInt(some.length)]));
    }
    ends[0] = end;
    Arrays.sort(ends);
    List<Run.Row> inSteps = new ArrayList<>();
    for (double time : ends) {
      boolean complete = false;
      while (!complete) {
        complete = twin.advanceTo(time);
        inSteps.addAll(Run.rows(twin.impacts()));
      }
    }
    return inSteps;
  }

  private static List<Run.State> states(World world) {
    List<Run.State> states = new ArrayList<>();
    for (int i = 0; i < world.idEnd(ObstacleKind.CIRCLE); i++) {
      if (world.contains(ObstacleKind.CIRCLE, i)) {
        states.add(new Run.State(world.x(i), world.y(i), world.vx(i), world.vy(i)));
      }
    }
    return states;
  }

  // Edits.

  /** Makes an edit; if worlds refuse it, both do so in the same words, and the model is spared. */
  private void edit(Consumer<World> edit, Consumer<PlainWorld> plainEdit) {
    String refusal = refusal(world, edit);
    assertThat(refusal(twin, edit)).isEqualTo(refusal);
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

  /** The id of a thing of a kind that is there, or -1. */
  private int some(ObstacleKind kind) {
    int end = world.idEnd(kind);
    for (int tries = 0; end > 0 && tries < 20; tries++) {
      int id = random.nextInt(end);
      if (world.contains(kind, id)) {
        return id;
      }
    }
    return -1;
  }

  private ObstacleKind kind() {
    return ObstacleKind.values()[random.nextInt(4)];
  }

  private void setMotion() {
    int id = some(ObstacleKind.CIRCLE);
    if (id >= 0 && random.nextBoolean()) {
      setVelocity(id);
    } else if (id >= 0) {
      double x = numbers.x();
      double y = numbers.y();
      edit(w -> w.setPosition(id, x, y), p -> p.setPosition(id, x, y));
    }
  }

  private void setVelocity(int id) {
    double vx = numbers.speed();
    double vy = numbers.speed();
    edit(w -> w.setVelocity(id, vx, vy), p -> p.setVelocity(id, vx, vy));
  }

  private void setProperties() {
    int id = some(ObstacleKind.CIRCLE);
    if (id >= 0) {
      double radius = numbers.radius();
      edit(w -> w.setRadius(id, radius), p -> p.setRadius(id, radius));
      double mass = numbers.mass();
      edit(w -> w.setMass(id, mass), p -> p.setMass(id, mass));
    }
    ObstacleKind kind = kind();
    int thing = some(kind);
    if (thing >= 0) {
      double e = numbers.restitution();
      edit(w -> w.setRestitution(kind, thing, e), p -> p.setRestitution(kind, thing, e));
    }
  }

  private void addCircle() {
    if (world.circleCount() < 10) {
      double x = numbers.x();
      double y = numbers.y();
      double radius = numbers.radius();
      double vx = numbers.speed();
      double vy = numbers.speed();
      edit(w -> w.addCircle(x, y, radius, vx, vy), p -> p.addCircle(x, y, radius, vx, vy));
    }
  }

  private void addObstacle() {
    double x = numbers.x();
    double y = numbers.y();
    if (random.nextInt(3) == 0) {
      double radius = numbers.pegRadius();
      edit(w -> w.addPeg(x, y, radius), p -> p.addPeg(x, y, radius));
    } else {
      double bx = numbers.x();
      double by = numbers.y();
      edit(w -> w.addLine(x, y, bx, by), p -> p.addLine(x, y, bx, by));
    }
  }

  private void moveObstacle() {
    int line = some(ObstacleKind.LINE);
    int peg = some(ObstacleKind.PEG);
    double x = numbers.x();
    double y = numbers.y();
    if (line >= 0 && random.nextBoolean()) {
      double bx = numbers.x();
      double by = numbers.y();
      edit(w -> w.moveLine(line, x, y, bx, by), p -> p.moveLine(line, x, y, bx, by));
    } else if (peg >= 0) {
      double radius = numbers.pegRadius();
      edit(w -> w.movePeg(peg, x, y, radius), p -> p.movePeg(peg, x, y, radius));
    }
  }

  private void remove() {
    ObstacleKind kind = ObstacleKind.values()[1 + random.nextInt(3)];
    int id = some(kind);
    if (id >= 0 && (kind != ObstacleKind.CIRCLE || world.circleCount() > 2)) {
      edit(w -> w.remove(kind, id), p -> p.remove(kind, id));
      assertThat(world.contains(kind, id)).isFalse();
    }
  }

  private void setTraits() {
    ObstacleKind kind = kind();
    int id = some(kind);
    int most = sensors && kind != ObstacleKind.WALL ? 3 : 2;
    Response response = Response.values()[random.nextInt(4) == 0 ? random.nextInt(most) : 0];
    if (id >= 0) {
      edit(w -> w.setResponse(kind, id, response), p -> p.setResponse(kind, id, response));
    }
    if (id >= 0 && kind == ObstacleKind.LINE) {
      boolean oneWay = random.nextInt(3) == 0;
      edit(w -> w.setOneWay(id, oneWay), p -> p.setOneWay(id, oneWay));
    }
  }

  // Snapshots.

  private void snapshot() throws IOException {
    Snapshot snapshot = world.snapshot();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    snapshot.write(out);
    Snapshot read = Snapshot.read(new ByteArrayInputStream(out.toByteArray()));
    assertThat(read).isEqualTo(snapshot);
    snapshots.add(random.nextBoolean() ? snapshot : read);
    plainSnapshots.add(plain.copy());
  }

  private void restore() {
    if (snapshots.isEmpty()) {
      return;
    }
    int i = random.nextInt(snapshots.size());
    if (aside.nextBoolean()) {
      world = new World(scene);
      twin = new World(scene, machinery);
    }
    world.restore(snapshots.get(i));
    twin.restore(snapshots.get(i));
    plain.restore(plainSnapshots.get(i));
    assertThat(world.snapshot()).isEqualTo(snapshots.get(i));
  }
}
