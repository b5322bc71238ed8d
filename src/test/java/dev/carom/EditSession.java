// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Edits, steps, snapshots and restores of {@link ThreeWorlds} in random order. */
final class EditSession {

  private final Random random;
  private final SessionNumbers numbers;
  private final int length;
  private final int mostImpacts;
  private final boolean sensors;

  /** The source of random filters; null for a session without filters. */
  private final Random masks;

  /** The source of random velocities of obstacles; null if none moves. */
  private final Random motion;

  /** The source of random turns; null if nothing turns. */
  private final Random turning;

  /** The source of random gravity; null for a session without. */
  private final Random falling;

  private final ThreeWorlds worlds;
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
   * @param masked whether circles and obstacles have filters
   * @param moving whether lines and pegs move
   * @param falls whether there is gravity
   * @param length how many edits it has at most
   * @param mostImpacts a step of more ends it: the model would take minutes
   */
  EditSession(
      long seed,
      boolean collide,
      boolean hard,
      boolean masked,
      boolean moving,
      boolean falls,
      int length,
      int mostImpacts) {
    random = new Random(seed);
    masks = masked ? new Random(seed + 2) : null;
    motion = moving ? new Random(seed + 1) : null;
    turning = moving && seed % 3 == 0 ? new Random(seed + 4) : null;
    falling = falls ? new Random(seed + 3) : null;
    this.length = length;
    this.mostImpacts = mostImpacts;
    numbers = hard ? new SessionNumbers.Hard(random, falls) : new SessionNumbers(random);
    sensors = random.nextBoolean();
    worlds = new ThreeWorlds(scene(collide, hard), numbers.length(), ~seed);
  }

  private Scene scene(boolean collide, boolean hard) {
    SceneBuilder builder = Scene.builder().collide(collide);
    if (falling != null && numbers.begin() == 0 && falling.nextInt(3) > 0) {
      builder.gravity(pull(), pull());
    }
    if (!hard || random.nextInt(4) > 0) {
      double least = numbers.origin();
      double width = SessionNumbers.WIDTH * numbers.length();
      double height = SessionNumbers.HEIGHT * numbers.length();
      filter(builder.bounds(least, least, least + width, least + height));
    }
    for (int i = random.nextInt(12); i > 0; i--) {
      filter(builder.line(numbers.x(), numbers.y(), numbers.x(), numbers.y()));
    }
    for (int i = random.nextInt(3); i > 0; i--) {
      filter(builder.peg(numbers.x(), numbers.y(), numbers.pegRadius()));
    }
    boolean waits = numbers.begin() > 0;
    for (int i = numbers.circles(); i > 0; i--) {
      filter(
          builder.circle(numbers.x(), numbers.y(), numbers.radius(), speed(waits), speed(waits)));
    }
    return builder.build();
  }

  /** A component of gravity, which is often 0. */
  private double pull() {
    return falling.nextInt(3) == 0 ? 0 : numbers.gravity(falling);
  }

  /** Gives a filter to every other thing. */
  private void filter(SceneBuilder builder) {
    if (masks != null && masks.nextBoolean()) {
      builder.filter(new Filter(bits(), bits()));
    }
  }

  /** Each of three bits is set three times of four: as a rule two such sets have one in common. */
  private int bits() {
    return masks.ints(2, 0, 8).reduce(0, (a, b) -> a | b);
  }

  private double speed(boolean waits) {
    return waits ? 0 : numbers.speed();
  }

  /** Edits, steps, snapshots and restores so far. */
  int done() {
    return done;
  }

  /** How many states of the past were as the world gave them. */
  int compared() {
    return worlds.compared();
  }

  boolean isStuck() {
    return stuck;
  }

  /** Plays it to its end, and returns the number of impacts. */
  int run() {
    begin();
    while (done < length && !stuck) {
      if (masks != null && masks.nextInt(10) == 0) {
        setFilter();
      }
      if (motion != null && motion.nextInt(4) == 0) {
        setObstacleInMotion();
      }
      if (falling != null && falling.nextInt(12) == 0) {
        setGravity();
      }
      act(random.nextInt(20));
      done++;
    }
    worlds.comparePast();
    return impacts;
  }

  private void begin() {
    if (numbers.begin() > 0) {
      advance(numbers.begin());
      for (int id = 0; id < world().count(Kind.CIRCLE); id++) {
        setVelocity(id);
      }
    }
  }

  private void act(int what) {
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

  private World world() {
    return worlds.world();
  }

  private void step(double dt) {
    advance(world().now() + dt);
  }

  private void advance(double end) {
    int happened = worlds.advance(end, mostImpacts);
    stuck = happened < 0;
    impacts += Math.max(0, happened);
  }

  // Edits.

  /** The id of a thing of a kind that is there, or -1. */
  private int some(Kind kind) {
    int end = world().idLimit(kind);
    for (int tries = 0; end > 0 && tries < 20; tries++) {
      int id = random.nextInt(end);
      if (world().contains(kind, id)) {
        return id;
      }
    }
    return -1;
  }

  private Kind kind() {
    return Kind.values()[random.nextInt(4)];
  }

  private void setMotion() {
    int id = some(Kind.CIRCLE);
    if (id >= 0 && random.nextBoolean()) {
      setVelocity(id);
    } else if (id >= 0) {
      double x = numbers.x();
      double y = numbers.y();
      worlds.edit(w -> w.setPosition(id, x, y), p -> p.setPosition(id, x, y));
    }
  }

  private void setVelocity(int id) {
    double vx = numbers.speed();
    double vy = numbers.speed();
    worlds.edit(w -> w.setVelocity(id, vx, vy), p -> p.setVelocity(id, vx, vy));
  }

  /** Often with whole velocities, those of circles, or to rest, or to a place, or about a pivot. */
  private void setObstacleInMotion() {
    Kind kind = motion.nextBoolean() ? Kind.LINE : Kind.PEG;
    int id = some(kind);
    if (id >= 0 && turning != null && turning.nextBoolean()) {
      turn(kind, id);
    } else if (id >= 0 && motion.nextInt(5) == 0) {
      double x = numbers.x();
      double y = numbers.y();
      double arrival = world().now() + numbers.duration(4, motion.nextBoolean());
      worlds.edit(w -> w.moveTo(kind, id, x, y, arrival), p -> p.moveTo(kind, id, x, y, arrival));
    } else if (id >= 0) {
      double vx = motion.nextInt(5) == 0 ? 0 : numbers.speed();
      double vy = motion.nextInt(5) == 0 ? 0 : numbers.speed();
      worlds.edit(w -> w.setVelocity(kind, id, vx, vy), p -> p.setVelocity(kind, id, vx, vy));
    }
  }

  /** About any point, or the place of the thing; often by half of a right angle, or hardly. */
  private void turn(Kind kind, int id) {
    Line line = kind == Kind.LINE ? world().line(id) : null;
    Vec2 place = line == null ? world().peg(id).center() : line.start();
    boolean isThere = turning.nextBoolean();
    double x = isThere ? place.x() : numbers.x();
    double y = isThere ? place.y() : numbers.y();
    double part = turning.nextBoolean() ? 0.5 : turning.nextInt(8) == 0 ? 1e-12 : 1;
    double angle = 0.5 * Math.PI * (turning.nextBoolean() ? part : part * turning.nextGaussian());
    double arrival = world().now() + numbers.duration(4, turning.nextBoolean());
    worlds.edit(
        w -> w.turn(kind, id, x, y, angle, arrival), p -> p.turn(kind, id, x, y, angle, arrival));
  }

  private void setGravity() {
    double gx = pull();
    double gy = pull();
    worlds.edit(w -> w.setGravity(gx, gy), p -> p.setGravity(gx, gy));
  }

  private void setProperties() {
    int id = some(Kind.CIRCLE);
    if (id >= 0) {
      double radius = numbers.radius();
      worlds.edit(
          w -> w.setShape(Kind.CIRCLE, id, new Circle(w.x(id), w.y(id), radius)),
          p -> p.setRadius(id, radius));
      double mass = numbers.mass();
      worlds.edit(
          w -> w.setTraits(Kind.CIRCLE, id, w.traits(Kind.CIRCLE, id).withMass(mass)),
          p -> p.setMass(id, mass));
    }
    Kind kind = kind();
    int thing = some(kind);
    if (thing >= 0) {
      double e = numbers.restitution();
      worlds.edit(
          w -> w.setTraits(kind, thing, w.traits(kind, thing).withRestitution(e)),
          p -> p.setRestitution(kind, thing, e));
    }
  }

  private void addCircle() {
    if (world().count(Kind.CIRCLE) < 10) {
      double x = numbers.x();
      double y = numbers.y();
      double radius = numbers.radius();
      double vx = numbers.speed();
      double vy = numbers.speed();
      worlds.edit(
          w -> w.addCircle(x, y, radius, vx, vy, Traits.DEFAULT),
          p -> p.addCircle(x, y, radius, vx, vy));
    }
  }

  private void addObstacle() {
    double x = numbers.x();
    double y = numbers.y();
    if (random.nextInt(3) == 0) {
      double radius = numbers.pegRadius();
      worlds.edit(w -> w.addPeg(x, y, radius, Traits.DEFAULT), p -> p.addPeg(x, y, radius));
    } else {
      double bx = numbers.x();
      double by = numbers.y();
      worlds.edit(w -> w.addLine(x, y, bx, by, Traits.DEFAULT), p -> p.addLine(x, y, bx, by));
    }
  }

  private void moveObstacle() {
    int line = some(Kind.LINE);
    int peg = some(Kind.PEG);
    double x = numbers.x();
    double y = numbers.y();
    if (line >= 0 && random.nextBoolean()) {
      double bx = numbers.x();
      double by = numbers.y();
      worlds.edit(
          w -> w.setShape(Kind.LINE, line, new Line(x, y, bx, by)),
          p -> p.moveLine(line, x, y, bx, by));
    } else if (peg >= 0) {
      double radius = numbers.pegRadius();
      worlds.edit(
          w -> w.setShape(Kind.PEG, peg, new Circle(x, y, radius)),
          p -> p.movePeg(peg, x, y, radius));
    }
  }

  private void remove() {
    Kind kind = Kind.values()[1 + random.nextInt(3)];
    int id = some(kind);
    if (id >= 0 && (kind != Kind.CIRCLE || world().count(Kind.CIRCLE) > 2)) {
      worlds.edit(w -> w.remove(kind, id), p -> p.remove(kind, id));
      assertThat(world().contains(kind, id)).isFalse();
    }
  }

  private void setTraits() {
    Kind kind = kind();
    int id = some(kind);
    int most = sensors && kind != Kind.WALL ? 3 : 2;
    Response response = Response.values()[random.nextInt(4) == 0 ? random.nextInt(most) : 0];
    if (id >= 0) {
      worlds.edit(
          w -> w.setTraits(kind, id, w.traits(kind, id).withResponse(response)),
          p -> p.setResponse(kind, id, response));
    }
    if (id >= 0 && kind == Kind.LINE) {
      boolean oneWay = random.nextInt(3) == 0;
      worlds.edit(
          w -> w.setTraits(Kind.LINE, id, w.traits(Kind.LINE, id).withOneWay(oneWay)),
          p -> p.setOneWay(id, oneWay));
    }
  }

  private void setFilter() {
    Kind kind = Kind.values()[masks.nextInt(4)];
    int[] ids = world().ids(kind);
    if (ids.length > 0) {
      int id = ids[masks.nextInt(ids.length)];
      int category = bits();
      int mask = bits();
      worlds.edit(
          w -> w.setTraits(kind, id, w.traits(kind, id).withFilter(new Filter(category, mask))),
          p -> p.setFilter(kind, id, category, mask));
      assertThat(world().traits(kind, id).filter().category()).isEqualTo(category);
      assertThat(world().traits(kind, id).filter().mask()).isEqualTo(mask);
    }
  }

  // Snapshots.

  private void snapshot() {
    Snapshot snapshot = worlds.snapshot();
    Snapshot read = SnapshotBytes.copy(snapshot);
    assertThat(read).isEqualTo(snapshot);
    snapshots.add(random.nextBoolean() ? snapshot : read);
    plainSnapshots.add(worlds.plainSnapshot());
  }

  private void restore() {
    if (!snapshots.isEmpty()) {
      int i = random.nextInt(snapshots.size());
      worlds.restore(snapshots.get(i), plainSnapshots.get(i));
    }
  }
}
