// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Edits, steps, snapshots and restores in random order: a world does what the plain model does,
 * which searches everything anew. {@code -Dcarom.edits=1000000} makes a longer run of it, {@code
 * -Dcarom.seed} another one.
 */
class EditsTest {

  private static final int EDITS = Integer.getInteger("carom.edits", 6_000);
  private static final int SEED = Integer.getInteger("carom.seed", 1);

  /** After so many edits a new scene begins. */
  private static final int EDITS_PER_SCENE = 500;

  /** A step of more, in a corridor hardly wider than the circle, would take the model minutes. */
  private static final int MOST_IMPACTS = 5_000;

  @Tag("long")
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void theWorldDoesWhatThePlainModelDoes(boolean collide) throws IOException {
    int impacts = 0;
    int done = 0;
    int stuck = 0;
    for (int i = 0; done < EDITS; i++) {
      long seed = SEED * 1_000_003L + (long) i * EDITS_PER_SCENE;
      Session session = new Session(new Random(seed), collide);
      try {
        impacts += session.run();
      } catch (AssertionError e) {
        throw new AssertionError("session %d, collide %b".formatted(seed, collide), e);
      }
      done += session.done;
      stuck += session.stuck ? 1 : 0;
    }
    System.out.printf(
        "%,d edits, steps, snapshots and restores, collide %b: %,d impacts as in the plain model"
            + " (%d sessions ended where a circle was stuck)%n",
        done, collide, impacts, stuck);
    assertThat(impacts).isGreaterThan(EDITS / 4);
  }

  /**
   * A line before a wall that is as good as touched; an edited circle whose line is moved; a line
   * removed that a circle was about to hit at once.
   */
  @ParameterizedTest
  @CsvSource({"7022521, false", "7016021, true", "5386515, true"})
  void sessionsThatOnceDiffered(long seed, boolean collide) throws IOException {
    assertThat(new Session(new Random(seed), collide).run()).isPositive();
  }

  /** Short ones, for who cannot wait for the long run. */
  @ParameterizedTest
  @CsvSource({"1, false", "2, true", "3, false", "4, true"})
  void aSessionDoesWhatThePlainModelDoes(long seed, boolean collide) throws IOException {
    assertThat(new Session(new Random(seed), collide).run()).isPositive();
  }

  /** A world, its plain model, and what was kept of both. */
  private static final class Session {

    private final Random random;
    private final World world;
    private final PlainWorld plain;
    private final List<Snapshot> snapshots = new ArrayList<>();
    private final List<PlainWorld> plainSnapshots = new ArrayList<>();
    private final boolean sensors;
    private int impacts;
    private int done;

    /** A circle is in a corridor that is hardly wider than itself: too much for the model. */
    private boolean stuck;

    Session(Random random, boolean collide) {
      this.random = random;
      sensors = random.nextBoolean();
      Scene scene = scene(collide);
      world = new World(scene);
      plain = new PlainWorld(scene);
    }

    private Scene scene(boolean collide) {
      SceneBuilder builder = Scene.builder().bounds(0, 0, 100, 80).collide(collide);
      for (int i = random.nextInt(12); i > 0; i--) {
        builder.line(x(), y(), x(), y());
      }
      for (int i = random.nextInt(3); i > 0; i--) {
        builder.peg(x(), y(), random.nextInt(6));
      }
      for (int i = 2 + random.nextInt(6); i > 0; i--) {
        builder.circle(x(), y(), radius(), speed(), speed());
      }
      return builder.build();
    }

    /** Often whole numbers, so that there are ties. */
    private double x() {
      return random.nextBoolean() ? 5 * random.nextInt(21) : 100 * random.nextDouble();
    }

    private double y() {
      return random.nextBoolean() ? 5 * random.nextInt(17) : 80 * random.nextDouble();
    }

    private double radius() {
      return random.nextBoolean() ? 1 + random.nextInt(4) : 0.5 + 4 * random.nextDouble();
    }

    private double speed() {
      return random.nextBoolean() ? random.nextInt(11) - 5 : 3 * random.nextGaussian();
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

    int run() throws IOException {
      while (done < EDITS_PER_SCENE && !stuck) {
        act(random.nextInt(20));
        done++;
      }
      return impacts;
    }

    private void act(int what) throws IOException {
      switch (what) {
        case 0, 1, 2 -> step(random.nextDouble() * 2);
        case 3 -> step(random.nextInt(3));
        case 4, 5 -> setMotion();
        case 6 -> setProperties();
        case 7 -> addCircle();
        case 8 -> addObstacle();
        case 9, 10 -> moveObstacle();
        case 11 -> remove();
        case 12 -> setTraits();
        case 13 -> snapshot();
        case 14 -> restore();
        default -> step(random.nextDouble() / 4);
      }
    }

    private void step(double dt) {
      double end = world.now() + dt;
      if (!world.step(dt) || world.impacts().size() > MOST_IMPACTS) {
        stuck = true;
        return;
      }
      List<Run.Row> rows = Run.rows(world.impacts());
      assertThat(Run.rows(plain.advance(end, rows.size() + 1))).isEqualTo(rows);
      impacts += rows.size();
    }

    private void setMotion() {
      int id = some(ObstacleKind.CIRCLE);
      if (id >= 0 && random.nextBoolean()) {
        double vx = speed();
        double vy = speed();
        world.setVelocity(id, vx, vy);
        plain.setVelocity(id, vx, vy);
      } else if (id >= 0) {
        double x = x();
        double y = y();
        world.setPosition(id, x, y);
        plain.setPosition(id, x, y);
      }
    }

    private void setProperties() {
      int id = some(ObstacleKind.CIRCLE);
      if (id >= 0) {
        double radius = radius();
        world.setRadius(id, radius);
        plain.setRadius(id, radius);
        double mass = 1 + random.nextInt(3);
        world.setMass(id, mass);
        plain.setMass(id, mass);
      }
      ObstacleKind kind = kind();
      int thing = some(kind);
      if (thing >= 0) {
        double e = random.nextInt(4) == 0 ? 0.9 : 1;
        world.setRestitution(kind, thing, e);
        plain.setRestitution(kind, thing, e);
      }
    }

    private ObstacleKind kind() {
      return ObstacleKind.values()[random.nextInt(4)];
    }

    private void addCircle() {
      if (world.circleCount() < 10) {
        double x = x();
        double y = y();
        double radius = radius();
        double vx = speed();
        double vy = speed();
        assertThat(world.addCircle(x, y, radius, vx, vy))
            .isEqualTo(world.idEnd(ObstacleKind.CIRCLE) - 1);
        plain.addCircle(x, y, radius, vx, vy);
      }
    }

    private void addObstacle() {
      double x = x();
      double y = y();
      if (random.nextInt(3) == 0) {
        double radius = random.nextInt(6);
        world.addPeg(x, y, radius);
        plain.addPeg(x, y, radius);
      } else {
        double bx = x();
        double by = y();
        world.addLine(x, y, bx, by);
        plain.addLine(x, y, bx, by);
      }
    }

    private void moveObstacle() {
      int line = some(ObstacleKind.LINE);
      int peg = some(ObstacleKind.PEG);
      double x = x();
      double y = y();
      if (line >= 0 && random.nextBoolean()) {
        double bx = x();
        double by = y();
        world.moveLine(line, x, y, bx, by);
        plain.moveLine(line, x, y, bx, by);
      } else if (peg >= 0) {
        double radius = random.nextInt(6);
        world.movePeg(peg, x, y, radius);
        plain.movePeg(peg, x, y, radius);
      }
    }

    private void remove() {
      ObstacleKind kind = ObstacleKind.values()[1 + random.nextInt(3)];
      int id = some(kind);
      if (id >= 0 && (kind != ObstacleKind.CIRCLE || world.circleCount() > 2)) {
        world.remove(kind, id);
        plain.remove(kind, id);
        assertThat(world.contains(kind, id)).isFalse();
      }
    }

    private void setTraits() {
      ObstacleKind kind = kind();
      int id = some(kind);
      int most = sensors && kind != ObstacleKind.WALL ? 3 : 2;
      Response response = Response.values()[random.nextInt(4) == 0 ? random.nextInt(most) : 0];
      if (id >= 0) {
        world.setResponse(kind, id, response);
        plain.setResponse(kind, id, response);
      }
      if (id >= 0 && kind == ObstacleKind.LINE) {
        boolean oneWay = random.nextInt(3) == 0;
        world.setOneWay(id, oneWay);
        plain.setOneWay(id, oneWay);
      }
    }

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
      if (!snapshots.isEmpty()) {
        int i = random.nextInt(snapshots.size());
        world.restore(snapshots.get(i));
        plain.restore(plainSnapshots.get(i));
        assertThat(world.snapshot()).isEqualTo(snapshots.get(i));
      }
    }
  }
}
