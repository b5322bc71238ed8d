// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Circle;
import dev.carom.Filter;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Nearest;
import dev.carom.Outline;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.Sides;
import java.util.Optional;

/**
 * The thing that the mouse holds: a circle, a peg, a line as a whole, or one of its ends. A circle
 * that is let go of while it moves is thrown.
 */
final class Grip {

  private enum Part {
    CIRCLE(Kind.CIRCLE),
    PEG(Kind.PEG),
    LINE(Kind.LINE),
    START(Kind.LINE),
    END(Kind.LINE);

    private final Kind kind;

    Part(Kind kind) {
      this.kind = kind;
    }
  }

  private static final double NANOS_A_TICK = 1e9 / 60;

  /** A mouse that rested for so long before it let go throws nothing. */
  private static final long STILL = 120_000_000;

  /** The time after which a motion of the mouse weighs less by e: some three of its events. */
  private static final double FADE = 50e6;

  private final Player player;
  private final Part part;
  private final int id;

  /** The velocity of a circle before it was held. */
  private final Vec2 velocity;

  private Vec2 last;
  private Vec2 place;

  /** The way of the mouse and its time in nanoseconds; what is longer ago weighs less. */
  private Vec2 way = Vec2.ZERO;

  private double time;
  private long moved;
  private boolean carried;

  private Grip(Player player, Part part, int id, Vec2 at, Vec2 place, Vec2 velocity) {
    this.player = player;
    this.part = part;
    this.id = id;
    this.velocity = velocity;
    this.place = place;
    last = at;
  }

  /**
   * Takes hold of what lies at a point: circles first, then pegs.
   *
   * @param reach how far beside it the point may lie
   * @return null if nothing is there
   */
  static Grip at(Player player, Vec2 point, double reach) {
    World world = player.look();
    Circle around = new Circle(point.x(), point.y(), reach);
    int circle = last(world.withFilter(Filter.ALL).overlapping(Kind.CIRCLE, around));
    if (circle >= 0) {
      Vec2 place = new Vec2(world.x(circle), world.y(circle));
      Vec2 velocity = new Vec2(world.vx(circle), world.vy(circle));
      return new Grip(player, Part.CIRCLE, circle, point, place, velocity);
    }
    int peg = last(world.withFilter(Filter.ALL).overlapping(Kind.PEG, around));
    if (peg >= 0) {
      return new Grip(player, Part.PEG, peg, point, world.peg(peg).center(), Vec2.ZERO);
    }
    Optional<Nearest> near = world.withFilter(Filter.ALL).nearest(point.x(), point.y(), Kind.LINE);
    int id = near.map(Nearest::id).orElse(-1);
    if (id < 0 || near.get().distance() > reach) {
      return null;
    }
    if (!(world.shape(Kind.LINE, id) instanceof Line line)) {
      return new Grip(player, Part.LINE, id, point, point, Vec2.ZERO);
    }
    Part part =
        distance(new Vec2(line.ax(), line.ay()), point) <= reach
            ? Part.START
            : distance(new Vec2(line.bx(), line.by()), point) <= reach ? Part.END : Part.LINE;
    return new Grip(player, part, id, point, point, Vec2.ZERO);
  }

  private static int last(int[] ids) {
    return ids.length == 0 ? -1 : ids[ids.length - 1];
  }

  private static double distance(Vec2 a, Vec2 b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y());
  }

  /** The kind of the thing. */
  Kind kind() {
    return part.kind;
  }

  int id() {
    return id;
  }

  /** The circle as it is, with its velocity; null of anything else. */
  String about() {
    if (part != Part.CIRCLE) {
      return null;
    }
    World world = player.look();
    double speed = Math.hypot(world.vx(id), world.vy(id));
    return String.format(
        "circle %d at %.6g, %.6g; speed %.4g; radius %.4g",
        id, world.x(id), world.y(id), speed, world.radius(id));
  }

  /** Moves it along with the mouse, at a time of the clock in nanoseconds. */
  void drag(Vec2 to, long nanos) {
    Vec2 by = new Vec2(to.x() - last.x(), to.y() - last.y());
    last = to;
    remember(by, nanos - moved);
    moved = nanos;
    move(by);
  }

  private void remember(Vec2 by, long nanos) {
    if (nanos > STILL) {
      way = Vec2.ZERO;
      time = 0;
      return;
    }
    double weight = Math.exp(-nanos / FADE);
    way = new Vec2(weight * way.x() + by.x(), weight * way.y() + by.y());
    time = weight * time + nanos;
  }

  private void move(Vec2 by) {
    Vec2 to = new Vec2(place.x() + by.x(), place.y() + by.y());
    if (part == Part.CIRCLE) {
      player.moveCircle(id, to.x(), to.y());
    } else if (part == Part.PEG) {
      player.movePeg(id, to.x(), to.y());
    } else if (player.look().shape(Kind.LINE, id) instanceof Outline outline) {
      player.moveLine(id, Sides.moved(outline, by));
    } else {
      Line l = player.look().line(id);
      double a = part == Part.END ? 0 : 1;
      double b = part == Part.START ? 0 : 1;
      player.moveLine(
          id,
          new Line(
              l.ax() + a * by.x(), l.ay() + a * by.y(), l.bx() + b * by.x(), l.by() + b * by.y()));
    }
    place = to;
  }

  /** Keeps a circle where the mouse is while the world goes on. */
  void hold() {
    if (part == Part.CIRCLE) {
      player.throwCircle(id, 0, 0);
      player.moveCircle(id, place.x(), place.y());
      carried = true;
    }
  }

  /** Lets go at a time of the clock: a circle flies on as the mouse moved, or as it did before. */
  void release(long nanos) {
    if (part != Part.CIRCLE) {
      return;
    }
    boolean thrown = nanos - moved <= STILL && !way.equals(Vec2.ZERO);
    if (thrown) {
      // Events that come late come several at one moment: their own time would be far too short.
      double ticks = Math.max(FADE, time) / NANOS_A_TICK * player.frame();
      player.throwCircle(id, way.x() / ticks, way.y() / ticks);
    } else if (carried) {
      player.throwCircle(id, velocity.x(), velocity.y());
    }
  }
}
