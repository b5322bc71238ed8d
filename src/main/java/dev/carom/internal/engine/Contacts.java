// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.response.ContactCore;
import dev.carom.internal.response.ContactHost;
import dev.carom.internal.response.Shock;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FlightTable;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;

/**
 * Circles in contact under gravity, in the engine for circles that collide. It gives {@link
 * ContactCore} what is near, and turns flights of members into flights of the store: straight, and
 * known until the next tick.
 */
final class Contacts implements ContactHost, Shock.Others {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private final CollidingEngine engine;
  private final CircleTable circles;
  private final CircleRegistry registry;
  private final StaticScene staticScene;
  private final Gravity gravity;
  private final ImpactRows log;
  private final MovingCircle body = new MovingCircle();
  private final MovingCircle newcomer = new MovingCircle();
  private final MovingCircle place = new MovingCircle();
  private final IntList found = new IntList();

  /** Circles that left in the present tick. */
  private final IntList freed = new IntList();

  /** Null as long as nothing falls or turns. */
  private ContactCore core;

  private int room;

  Contacts(CollidingEngine engine, ImpactRows log) {
    this.engine = engine;
    this.log = log;
    circles = engine.circles;
    registry = engine.registry;
    staticScene = engine.staticScene;
    gravity = engine.gravity;
  }

  // Questions.

  double nextTick() {
    return core == null ? INFINITE : core.nextTick();
  }

  long work() {
    return core == null ? 0 : core.work();
  }

  boolean isAwake(int i) {
    return core != null && core.isAwake(i);
  }

  boolean isMember(int i) {
    return core != null && core.isMember(i);
  }

  /** Whether an impact of two circles is no event, since contact keeps them apart. */
  boolean keepsApart(int i, int j) {
    return core != null
        && (core.areMembers(i, j)
            || (core.isKeptApart(i) && registry.mass(j) == INFINITE)
            || (core.isKeptApart(j) && registry.mass(i) == INFINITE));
  }

  // Events.

  /** Makes a new core, for the present gravity and room, without members. */
  void reset() {
    room = circles.capacity();
    core =
        circles.allowsGravity()
            ? new ContactCore(
                staticScene.obstacles, registry, circles, this, room, gravity.x, gravity.y)
            : null;
  }

  /** Makes room for more circles. */
  void makeRoom(double now) {
    if (circles.capacity() == room) {
      return;
    }
    ContactCore old = core;
    reset();
    if (old == null) {
      return;
    }
    for (int i : registry.slots()) {
      if (old.isMember(i)) {
        circles.load(i, body);
        body.contactRow = old.save(i, registry);
        restore(body);
      }
    }
    core.restored(registry, now);
  }

  /**
   * Lets a circle of finite mass join, at the start of a new flight.
   *
   * @param partner the member that it met, or NONE
   */
  void join(int i, int partner) {
    circles.load(i, newcomer);
    MovingCircle m = newcomer;
    describe(i, m.restitution);
    core.join(i, partner, m);
    note(m.t);
  }

  /** Lets two circles join that met, at the starts of new flights; one may be a member. */
  void joinBoth(int i, int j) {
    boolean slidesOnlyJ = circles.support(j) >= 0 && circles.support(i) < 0;
    int first = core.isMember(i) || slidesOnlyJ ? j : i;
    int second = first == i ? j : i;
    joinNext(first, second);
    joinNext(second, first);
  }

  private void joinNext(int i, int other) {
    if (!core.isMember(i) && registry.mass(i) < INFINITE) {
      join(i, core.isMember(other) ? other : Index.NONE);
    }
  }

  private void describe(int i, double restitution) {
    double e = registry.halts(i) ? 0 : restitution;
    core.describe(i, circles.radius(i), registry.mass(i), e, registry.filter(i));
  }

  void tick(double now) {
    core.tick(now);
    for (int k = 0; k < freed.size(); k++) {
      int i = freed.get(k);
      engine.scheduler().findNextObstacle(circles.state, circles.codes, i);
      engine.scheduler().predict(i);
    }
    freed.clear();
    note(now);
  }

  void meet(int i, double now) {
    core.meet(i, now);
    note(now);
  }

  // Edits.

  /** Takes a circle out of contact, as an edit does; it has its momentum then. */
  void leave(MovingCircle m, double now) {
    if (core != null && core.isMember(m.id)) {
      m.move(MovingCircle.since(m.t, m.tl, now));
      m.t = now;
      m.tl = 0;
      m.vx = core.velocityX(m.id, now);
      m.vy = core.velocityY(m.id, now);
      m.fall(0, 0);
      circles.put(m.id, m);
      core.remove(m.id, now);
      note(now);
    }
  }

  void changed(int code, double now) {
    if (core == null) {
      return;
    }
    if (!Codes.isCircle(code) || registry.mass(Codes.slot(code)) == INFINITE) {
      core.changed(code, now);
    } else if (core.isMember(Codes.slot(code))) {
      describe(Codes.slot(code), circles.restitution(Codes.slot(code)));
      core.changed();
    }
    note(now);
  }

  // State.

  /** After a change: a stand at this time was not the last word. */
  private void note(double now) {
    if (engine.recorder != null && engine.recorder.isStand(now)) {
      engine.stand(now);
    }
  }

  void save(MovingCircle m) {
    if (core != null && core.isMember(m.id)) {
      m.contactRow = core.save(m.id, registry);
    }
  }

  private void restore(MovingCircle m) {
    describe(m.id, m.restitution);
    core.restore(m.id, m);
  }

  void restore(FlightTable flights, double now) {
    reset();
    for (int i = 0; core != null && i < flights.capacity(); i++) {
      flights.get(i, body);
      body.id = i;
      if (body.isMember()) {
        restore(body);
      }
    }
    if (core != null) {
      core.restored(registry, now);
    }
  }

  // Without gravity.

  @Override
  public MovingCircle copyOf(int slot) {
    MovingCircle m = new MovingCircle();
    circles.load(slot, m);
    return m;
  }

  @Override
  public void circlesNear(MovingCircle m, double reach, IntList into) {
    addNear(m, reach, false, into);
  }

  private void addNear(MovingCircle m, double reach, boolean membersOnly, IntList into) {
    found.clear();
    engine.addNear(m.x, m.y, m.radius + reach, found);
    for (int k = 0; k < found.size(); k++) {
      int i = found.get(k);
      if (i != m.id && (!membersOnly || core.isMember(i)) && carries(i, m.id)) {
        into.add(i);
      }
    }
  }

  /** Whether two circles that touch keep each other out: no filter and no sensor lets them pass. */
  private boolean carries(int i, int j) {
    return registry.meet(i, j) && !registry.isSensor(i) && !registry.isSensor(j);
  }

  // The host.

  @Override
  public void membersNear(int slot, double x, double y, double reach, IntList into) {
    setPlace(slot, x, y);
    addNear(place, reach, true, into);
  }

  private void setPlace(int slot, double x, double y) {
    place.id = slot;
    place.radius = circles.radius(slot);
    place.x = x;
    place.y = y;
  }

  @Override
  public void obstaclesNear(int slot, double x, double y, double reach, double now, IntList into) {
    setPlace(slot, x, y);
    staticScene.addNear(place, reach, now, into);
    if (registry.hasInfinite()) {
      found.clear();
      engine.addNear(x, y, place.radius + reach, found);
      for (int k = 0; k < found.size(); k++) {
        if (registry.mass(found.get(k)) == INFINITE) {
          into.add(Codes.circle(found.get(k)));
        }
      }
    }
  }

  @Override
  public void flies(int slot) {
    circles.load(slot, body);
    core.put(slot, body);
    engine.beginMember(body, isAlone());
  }

  /** Whether there is nothing but members that move alike. */
  private boolean isAlone() {
    return core.present() == registry.count() && !staticScene.obstacles.areMoving();
  }

  @Override
  public void frees(int slot, double vx, double vy, int side) {
    circles.load(slot, body);
    core.free(slot, vx, vy, side, body);
    engine.beginFreed(body);
    freed.add(slot);
  }

  @Override
  public void jammed(int slot, int code, int part, double nx, double ny) {
    circles.load(slot, body);
    core.place(slot, body);
    log.addJammed(body, code, part, body.radius, nx, ny, 0);
  }
}
