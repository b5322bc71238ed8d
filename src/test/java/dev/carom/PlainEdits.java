// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.Filter;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.util.Kind;
import java.util.HashMap;

/** The edits of a {@link PlainWorld}: they change the flights as {@link World} tells. */
abstract class PlainEdits extends PlainSearch {

  PlainEdits(Scene scene) {
    super(scene);
  }

  PlainEdits(PlainState other) {
    super(other);
  }

  void setVelocity(int id, double vx, double vy) {
    MovingCircle m = restarted(id);
    m.vx = vx;
    m.vy = vy;
    m.forget();
  }

  void setPosition(int id, double x, double y) {
    MovingCircle m = restarted(id);
    m.x = x;
    m.y = y;
    m.forget();
  }

  void setRadius(int id, double radius) {
    MovingCircle m = restarted(id);
    m.radius = radius;
    if (m.isFalling()) {
      m.last = MovingCircle.NOTHING;
    }
  }

  /** Circles fall that lay on one which is about to change, if that rested. */
  private void freeHeap(int id) {
    MovingCircle m = copy(bodies.get(id));
    if (m.isGround()) {
      m.tl = tailOfEdit(m);
      m.t = now;
      for (MovingCircle other : heap.free(m)) {
        bodies.set(other.id, other);
        begin(other);
      }
    }
  }

  private MovingCircle restarted(int id) {
    freeHeap(id);
    MovingCircle m = begunAnew(id);
    release(m);
    return m;
  }

  void setGravity(double gx, double gy) {
    for (MovingCircle m : bodies) {
      if (registry.contains(m.id)) {
        begunAnew(m.id).forget();
      }
    }
    gravity.set(gx, gy);
    bodies.stream().filter(m -> registry.contains(m.id)).forEach(this::release);
  }

  /** Lets circles fall that slide or rest on an obstacle which is about to change. */
  private void letFallFrom(int code) {
    for (MovingCircle m : bodies) {
      boolean rests = m.isSupported() && m.gx == 0 && m.gy == 0;
      boolean isCarried =
          m.support == code || m.leftLine == code || (rests && response.settling.touches(m, code));
      if (registry.contains(m.id) && isCarried) {
        restarted(m.id).forget(code, 0);
      }
    }
  }

  /** A circle at the start of a new flight, which goes on as the one before. */
  private MovingCircle begunAnew(int id) {
    MovingCircle m = bodies.get(id);
    boolean confined = meets(id, obstacles.filter(Codes.LEFT));
    m.restart(now, tailOfEdit(m), confined ? obstacles.walls : null);
    begin(m);
    if (registry.mass(id) == Double.POSITIVE_INFINITY) {
      leaveJamsOf(id);
    }
    return m;
  }

  /** Circles fall that rest only since a circle, which is edited, pressed them. */
  private void leaveJamsOf(int id) {
    int code = Codes.circle(id);
    for (MovingCircle m : bodies) {
      boolean isPressed = m.jam != null && m.jam.isCrushedBy(code);
      if (registry.contains(m.id) && isPressed && m.pinned) {
        restarted(m.id).forget(code, 0);
      }
    }
    leaveJams(code);
  }

  /** An edit comes after all that happened: to the circle, if it is alone. */
  private double tailOfEdit(MovingCircle m) {
    double head = collide ? last : m.t;
    double tail = collide ? lastTail : m.tl;
    return head == now ? Math.max(0, tail) : 0;
  }

  void setMass(int id, double mass) {
    double never = Double.POSITIVE_INFINITY;
    boolean passes = (registry.mass(id) == never) != (mass == never);
    freeHeap(id);
    registry.setMass(id, mass);
    if (passes) {
      leaveJamsOf(id);
    }
    boolean held = collide && bodies.get(id).isFrozen();
    if (held || (passes && (collide || gravity.acts()))) {
      restarted(id).forget();
    }
  }

  void addCircle(double x, double y, double radius, double vx, double vy) {
    MovingCircle m = new MovingCircle();
    m.start(registry.add(), x, y, radius, vx, vy, 1);
    m.t = now;
    m.tl = tailOfEdit(m);
    release(m);
    bodies.add(m);
    met.add(new HashMap<>());
  }

  void addLine(double ax, double ay, double bx, double by) {
    appear(obstacles.add(Kind.LINE, ax, ay, bx, by));
  }

  void addPeg(double x, double y, double radius) {
    appear(obstacles.add(Kind.PEG, x, y, radius));
  }

  void moveLine(int id, double ax, double ay, double bx, double by) {
    letFallFrom(Codes.line(id));
    obstacles.move(Codes.line(id), new double[] {ax, ay, bx, by}, now);
    appear(Codes.line(id));
  }

  void movePeg(int id, double x, double y, double radius) {
    letFallFrom(Codes.peg(id));
    obstacles.move(Codes.peg(id), new double[] {x, y, radius}, now);
    appear(Codes.peg(id));
  }

  /** Lets a line or a peg move. */
  void setVelocity(ObstacleKind kind, int id, double vx, double vy) {
    int code = Codes.of(kind.ordinal(), id);
    letFallFrom(code);
    obstacles.setVelocity(code, vx, vy, now);
    appear(code);
  }

  void remove(ObstacleKind kind, int id) {
    switch (kind) {
      case LINE -> removeObstacle(Codes.line(id));
      case PEG -> removeObstacle(Codes.peg(id));
      default -> removeCircle(id);
    }
  }

  private void removeCircle(int id) {
    freeHeap(id);
    registry.remove(id);
    leaveJamsOf(id);
  }

  private void removeObstacle(int code) {
    letFallFrom(code);
    obstacles.remove(code);
    bodies.forEach(m -> m.forget(code, 0));
  }

  void setRestitution(ObstacleKind kind, int id, double e) {
    switch (kind) {
      case LINE -> obstacles.setRestitution(Codes.line(id), e);
      case PEG -> obstacles.setRestitution(Codes.peg(id), e);
      case WALL -> obstacles.setRestitution(id, e);
      case CIRCLE -> bodies.get(id).restitution = e;
    }
  }

  void setResponse(ObstacleKind kind, int id, Response response) {
    switch (kind) {
      case LINE, PEG -> {
        int code = (kind == ObstacleKind.LINE ? Codes.line(0) : Codes.peg(0)) + id;
        setTraits(code, ContactFlags.with(obstacles.traits(code), response.ordinal()));
      }
      case WALL ->
          obstacles.setTraits(id, ContactFlags.with(obstacles.boundsTraits, response.ordinal()));
      case CIRCLE -> {
        restarted(id);
        registry.setTraits(id, ContactFlags.with(registry.traits(id), response.ordinal()));
      }
    }
  }

  void setOneWay(int id, boolean oneWay) {
    int code = Codes.line(id);
    setTraits(code, ContactFlags.withOneWay(obstacles.traits(code), oneWay));
  }

  private void setTraits(int code, int traits) {
    if (traits != obstacles.traits(code)) {
      letFallFrom(code);
      obstacles.setTraits(code, traits);
      appear(code);
    }
  }

  void setFilter(ObstacleKind kind, int id, int category, int mask) {
    long filter = Filter.of(category, mask);
    switch (kind) {
      case LINE, PEG -> {
        int code = (kind == ObstacleKind.LINE ? Codes.line(0) : Codes.peg(0)) + id;
        if (filter != obstacles.filter(code)) {
          letFallFrom(code);
          obstacles.setFilter(code, filter);
          appear(code);
        }
      }
      case WALL -> setFilterOfWalls(filter);
      case CIRCLE -> {
        if (filter != registry.filter(id)) {
          restarted(id).forget();
          registry.setFilter(id, filter);
          bodies.get(id).filter = filter;
        }
      }
    }
  }

  private void setFilterOfWalls(long filter) {
    for (MovingCircle m : bodies) {
      boolean was = meets(m.id, obstacles.filter(Codes.LEFT));
      if (registry.contains(m.id) && was != meets(m.id, filter)) {
        restarted(m.id).forget();
      }
    }
    obstacles.setFilter(Codes.LEFT, filter);
  }

  /** Flights that would meet a thing that was not there begin anew. */
  private void appear(int code) {
    for (MovingCircle m : bodies) {
      if (registry.contains(m.id)) {
        m.forget(code, 0);
        if (meets(m.id, obstacles.filter(code)) && isAhead(m, code)) {
          begunAnew(m.id);
        }
      }
    }
  }
}
