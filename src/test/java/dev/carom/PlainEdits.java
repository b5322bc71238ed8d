// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.util.KindNumber;
import java.util.Arrays;
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

  /** Takes a circle that is about to change out of contact. */
  private void leaveContact(int id) {
    MovingCircle m = bodies.get(id);
    if (collide) {
      contacts.leave(m, now);
    } else if (m.isMember()) {
      lone.leave(m, now);
    }
  }

  /** Notes for contact that a thing comes, goes or changes. */
  private void noteContact(int code) {
    if (collide) {
      contacts.changed(code, now);
    } else if (!Codes.isCircle(code)) {
      lone.changed();
      for (MovingCircle m : bodies) {
        if (registry.contains(m.id) && m.isMember() && lone.isNear(m, code, now)) {
          lone.leave(m, now);
          m.newFlight();
          release(m);
          begin(m);
        }
      }
    }
  }

  private MovingCircle restarted(int id) {
    leaveContact(id);
    MovingCircle m = begunAnew(id);
    release(m);
    return m;
  }

  void setGravity(double gx, double gy) {
    for (MovingCircle m : bodies) {
      if (registry.contains(m.id)) {
        leaveContact(m.id);
        begunAnew(m.id).forget();
      }
    }
    gravity.set(gx, gy);
    contacts = new PlainContacts(this);
    bodies.stream().filter(m -> registry.contains(m.id)).forEach(this::release);
  }

  /** Lets circles fall that slide on an obstacle which is about to change. */
  private void letFallFrom(int code) {
    noteContact(code);
    for (MovingCircle m : bodies) {
      if (registry.contains(m.id) && (m.support == code || m.landing == code)) {
        restarted(m.id).forget(code, 0);
      }
    }
  }

  /** A circle at the start of a new flight, which goes on as the one before. */
  private MovingCircle begunAnew(int id) {
    MovingCircle m = bodies.get(id);
    m.restart(now, tailOfEdit(m), obstacles);
    begin(m);
    if (registry.mass(id) == Double.POSITIVE_INFINITY) {
      leaveJams(Codes.circle(id));
      noteContact(Codes.circle(id));
    }
    return m;
  }

  /** An edit comes after all that happened: to the circle, if it is alone. */
  private double tailOfEdit(MovingCircle m) {
    double head = collide ? last : m.t;
    double tail = collide ? lastTail : m.tl;
    return head == now ? Math.max(0, tail) : 0;
  }

  void setMass(int id, double mass) {
    if (mass == registry.mass(id)) {
      return; // no edit
    }
    double never = Double.POSITIVE_INFINITY;
    boolean passes = (registry.mass(id) == never) != (mass == never);
    boolean held = collide && bodies.get(id).isMember();
    noteContact(Codes.circle(id));
    registry.setMass(id, mass);
    if (passes) {
      leaveJams(Codes.circle(id));
    }
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
    contacts = contacts.copy(this);
  }

  void addLine(double ax, double ay, double bx, double by) {
    appear(obstacles.add(KindNumber.LINE, ax, ay, bx, by));
  }

  void addPeg(double x, double y, double radius) {
    appear(obstacles.add(KindNumber.PEG, x, y, radius));
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
  void setVelocity(Kind kind, int id, double vx, double vy) {
    int code = Codes.of(kind.ordinal(), id);
    letFallFrom(code);
    obstacles.setVelocity(code, vx, vy, now);
    appear(code);
  }

  /** Sends a line or a peg to a place. */
  void moveTo(Kind kind, int id, double x, double y, double arrival) {
    int code = Codes.of(kind.ordinal(), id);
    double[] row = obstacles.rowAt(code, now, 0);
    double ux = (x - row[0]) / (arrival - now);
    double uy = (y - row[1]) / (arrival - now);
    if (kind == Kind.LINE) {
      row[2] = x + (row[2] - row[0]);
      row[3] = y + (row[3] - row[1]);
    }
    row[0] = x;
    row[1] = y;
    letFallFrom(code);
    double[] motion = new double[ObstacleMotions.SIZE];
    ObstacleMotions.setStraight(motion, 0, code, ux, uy, now, arrival);
    obstacles.moveTo(code, row, motion);
    appear(code);
  }

  /** Turns a line or a peg. */
  void turn(Kind kind, int id, double pivotX, double pivotY, double angle, double arrival) {
    int code = Codes.of(kind.ordinal(), id);
    double[] row = obstacles.rowAt(code, now, 0);
    double[] before = row.clone();
    double x = StrictMath.cos(0.5 * angle);
    double y = StrictMath.sin(0.5 * angle);
    for (int end = 0; end < (kind == Kind.LINE ? 4 : 2); end += 2) {
      ObstacleMotions.turn(pivotX, pivotY, x, y, row, end);
    }
    letFallFrom(code);
    double[] motion = ObstacleMotions.motion(code, 0, 0, now);
    if (!Arrays.equals(row, before)) {
      ObstacleMotions.setTurn(motion, pivotX, pivotY, angle, now, arrival);
    }
    obstacles.moveTo(code, row, motion);
    appear(code);
  }

  /** Stops what arrives now. */
  final void arrive() {
    for (int code : obstacles.motions().codes()) {
      if (obstacles.arrival(code) == now) {
        letFallFrom(code);
        obstacles.setVelocity(code, 0, 0, now);
        appear(code);
      }
    }
  }

  void remove(Kind kind, int id) {
    switch (kind) {
      case LINE -> removeObstacle(Codes.line(id));
      case PEG -> removeObstacle(Codes.peg(id));
      default -> removeCircle(id);
    }
  }

  private void removeCircle(int id) {
    leaveContact(id);
    noteContact(Codes.circle(id));
    registry.remove(id);
    leaveJams(Codes.circle(id));
  }

  private void removeObstacle(int code) {
    letFallFrom(code);
    obstacles.remove(code);
    noteContact(code);
    endContact();
    bodies.forEach(m -> m.forget(code, 0));
  }

  void setRestitution(Kind kind, int id, double e) {
    int code = Codes.of(kind.ordinal(), id);
    boolean isCircle = kind == Kind.CIRCLE;
    if (e == (isCircle ? bodies.get(id).restitution : obstacles.givenRestitution(code))) {
      return; // no edit
    }
    switch (kind) {
      case LINE -> obstacles.setRestitution(Codes.line(id), e);
      case PEG -> obstacles.setRestitution(Codes.peg(id), e);
      case WALL -> obstacles.setRestitution(id, e);
      case CIRCLE -> bodies.get(id).restitution = e;
    }
    if (kind == Kind.WALL) {
      noteWalls();
    } else {
      noteContact(code);
    }
  }

  void setResponse(Kind kind, int id, Response response) {
    switch (kind) {
      case LINE, PEG -> {
        int code = (kind == Kind.LINE ? Codes.line(0) : Codes.peg(0)) + id;
        setTraits(code, ContactFlags.with(obstacles.traits(code), response.ordinal()));
      }
      case WALL -> {
        int traits = ContactFlags.with(obstacles.boundsTraits, response.ordinal());
        if (traits != obstacles.boundsTraits) {
          obstacles.setTraits(id, traits);
          noteWalls();
        }
      }
      case CIRCLE -> {
        int traits = ContactFlags.with(registry.traits(id), response.ordinal());
        if (traits != registry.traits(id)) { // else it is no edit
          restarted(id);
          registry.setTraits(id, traits);
        }
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

  void setFilter(Kind kind, int id, int category, int mask) {
    long filter = FilterBits.of(category, mask);
    switch (kind) {
      case LINE, PEG -> {
        int code = (kind == Kind.LINE ? Codes.line(0) : Codes.peg(0)) + id;
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
    if (filter == obstacles.filter(Codes.LEFT)) {
      return; // no edit
    }
    for (MovingCircle m : bodies) {
      boolean was = meets(m.id, obstacles.filter(Codes.LEFT));
      if (registry.contains(m.id) && was != meets(m.id, filter)) {
        restarted(m.id).forget();
      }
    }
    obstacles.setFilter(Codes.LEFT, filter);
    noteWalls();
  }

  /** The walls have their traits together. */
  private void noteWalls() {
    for (int wall = 0; wall < Codes.WALLS; wall++) {
      noteContact(wall);
    }
  }

  /** Without gravity nothing is in contact once nothing turns. */
  private void endContact() {
    for (MovingCircle m : bodies) {
      boolean ends = !gravity.acts() && !obstacles.areTurning();
      if (ends && registry.contains(m.id) && m.isMember()) {
        restarted(m.id).forget();
      }
    }
  }

  /** Flights that would meet a thing that was not there begin anew. */
  private void appear(int code) {
    noteContact(code);
    endContact();
    for (MovingCircle m : bodies) {
      if (registry.contains(m.id)) {
        m.forget(code, 0);
        if (meets(m.id, obstacles.filter(code)) && !isHeldFrom(m, code) && isAhead(m, code)) {
          begunAnew(m.id);
        }
      }
    }
  }
}
