// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.SceneBuilder;
import dev.carom.Snapshot;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.Sides;
import java.util.HashMap;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;

/**
 * The velocities of the obstacles of a session, at its start and set between its steps. They are
 * drawn from a generator of their own, so that all else of the session is as it is without them.
 */
final class Motions {

  /** One of so many lines and pegs moves. */
  private static final int MOVING = 3;

  /** Between one of so many actions a velocity is set. */
  private static final int EDITS = 3;

  private static final long SALT = 0x6D6F76696E67L;

  private final Random random;

  /** The source of turns; null if nothing turns. */
  private final Random turn;

  private boolean turned;
  private final double length;
  private final double speed;

  /** The names of the obstacles that were turned last, and until when. */
  private final Map<String, Double> turns = new HashMap<>();

  /** The times to come at which obstacles arrive, unless they were sent elsewhere. */
  private final NavigableSet<Double> arrivals = new TreeSet<>();

  Motions(long seed, Numbers numbers) {
    random = new Random(seed ^ SALT);
    turn = (seed & 2) == 0 ? new Random(~seed ^ SALT) : null;
    length = numbers.length();
    speed = numbers.speedUnit();
  }

  /** Lets the line or peg just added move, or not. */
  void begin(SceneBuilder builder) {
    if (random.nextInt(MOVING) == 0) {
      builder.velocity(component(), component());
    }
  }

  /** Whole numbers as a rule, which circles have, too; sometimes very slow or very fast. */
  private double component() {
    double v = random.nextInt(3) > 0 ? random.nextInt(5) - 2.0 : random.nextGaussian();
    int rare = random.nextInt(20);
    return speed * v * (rare == 0 ? 1e-9 : rare == 1 ? 100 : 1);
  }

  /**
   * Sets a velocity or a place to go to, or turns something, or nothing; returns whether it did. An
   * edit that is refused must change nothing.
   */
  boolean edit(World world) throws FindingException {
    Kind kind = random.nextBoolean() ? Kind.LINE : Kind.PEG;
    int[] ids = world.ids(kind);
    if (ids.length == 0 || random.nextInt(EDITS) > 0) {
      return false;
    }
    int id = ids[random.nextInt(ids.length)];
    Vec2 v = velocity(place(world, kind, id));
    Snapshot before = world.snapshot();
    try {
      int what = turn != null && turn.nextInt(4) == 0 ? 3 : random.nextInt(3);
      if (what == 3) {
        turn(world, kind, id);
      } else if (what > 0) {
        world.setVelocity(kind, id, v.x(), v.y());
      } else {
        send(world, kind, id, v);
      }
      if (what != 3) {
        turns.remove(Solid.name(kind, id));
      }
    } catch (IllegalArgumentException e) {
      if (!world.snapshot().equals(before)) {
        throw new FindingException("a velocity that was refused changed the world: " + e, e);
      }
    }
    return true;
  }

  /** Lets it go on with a velocity for some steps, and then rest. */
  private void send(World world, Kind kind, int id, Vec2 v) {
    double time = length / speed * random.nextInt(1, 20);
    Vec2 from = place(world, kind, id);
    double arrival = world.now() + time;
    world.moveTo(kind, id, from.x() + v.x() * time, from.y() + v.y() * time, arrival);
    arrivals.add(arrival);
  }

  /** Turns it about any point of the box for some steps, often there and back. */
  private void turn(World world, Kind kind, int id) {
    double time = length / speed * turn.nextInt(1, 20);
    double x = length * Numbers.WIDTH * turn.nextDouble();
    double y = length * Numbers.HEIGHT * turn.nextDouble();
    double angle = turn.nextInt(4) == 0 ? 1e-6 * turn.nextGaussian() : turn.nextDouble() - 0.5;
    double arrival = world.now() + time;
    world.turn(kind, id, x, y, turn.nextBoolean() ? angle : Math.PI / 4, arrival);
    arrivals.add(arrival);
    turns.put(Solid.name(kind, id), arrival);
    turned = true;
  }

  /**
   * Whether anything has turned: circles may be in contact then, also without gravity, and contact
   * makes no rows.
   */
  boolean haveTurned() {
    return turned;
  }

  /** The names of the obstacles that may turn after a time. */
  Set<String> turning(double time) {
    turns.values().removeIf(arrival -> arrival <= time);
    return Set.copyOf(turns.keySet());
  }

  /** The first time after a given one at which an obstacle may arrive. */
  double nextArrival(double now) {
    arrivals.headSet(now, true).clear();
    return arrivals.isEmpty() ? Double.POSITIVE_INFINITY : arrivals.first();
  }

  /** One that leads back, of what has left the box; else any, or none. */
  private Vec2 velocity(Vec2 place) {
    double x = place.x() / length - Numbers.WIDTH / 2;
    double y = place.y() / length - Numbers.HEIGHT / 2;
    if (Math.abs(x) > Numbers.WIDTH || Math.abs(y) > Numbers.HEIGHT) {
      double scale = -2 * speed / Math.max(Math.abs(x), Math.abs(y));
      return new Vec2(scale * x, scale * y);
    }
    return random.nextInt(4) == 0 ? Vec2.ZERO : new Vec2(component(), component());
  }

  private static Vec2 place(World world, Kind kind, int id) {
    if (kind == Kind.PEG) {
      Circle peg = world.peg(id);
      return peg.center();
    }
    return Sides.of(world.shape(kind, id)).get(0).start();
  }
}
