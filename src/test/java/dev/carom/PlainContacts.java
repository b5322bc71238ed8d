// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.response.ContactCore;
import dev.carom.internal.response.ContactHost;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;

/** The circles of a {@link PlainWorld} in contact under gravity: everything is near everything. */
final class PlainContacts implements ContactHost {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private final PlainState world;
  private final int room;
  private final CircleTable table;
  private ContactCore core;

  PlainContacts(PlainState world) {
    this.world = world;
    room = world.bodies.size() + 1;
    table = CircleTable.colliding(room);
    table.allowGravity();
    if (world.collide) {
      core =
          new ContactCore(
              world.obstacles, world.registry, table, this, room, world.gravity.x, world.gravity.y);
    }
  }

  /** The same contacts for another world, or with room for more circles. */
  PlainContacts copy(PlainState other) {
    PlainContacts copy = new PlainContacts(other);
    for (MovingCircle m : world.bodies) {
      if (core != null && core.isMember(m.id)) {
        MovingCircle saved = PlainState.copy(world.bodies.get(m.id));
        saved.contactRow = core.save(m.id, world.registry);
        copy.describe(saved);
        copy.core.restore(m.id, saved);
      }
    }
    if (core != null) {
      copy.core.restored(other.registry, other.now);
    }
    return copy;
  }

  double nextTick() {
    return core == null ? INFINITE : core.nextTick();
  }

  boolean keepsApart(MovingCircle a, MovingCircle b) {
    return core != null
        && (core.areMembers(a.id, b.id)
            || (core.isKeptApart(a.id) && world.registry.mass(b.id) == INFINITE)
            || (core.isKeptApart(b.id) && world.registry.mass(a.id) == INFINITE));
  }

  void tick(double now) {
    show();
    core.tick(now);
  }

  void meet(int i, double now) {
    show();
    core.meet(i, now);
  }

  private void describe(MovingCircle m) {
    double e = world.registry.halts(m.id) ? 0 : m.restitution;
    core.describe(m.id, m.radius, world.registry.mass(m.id), e, world.registry.filter(m.id));
  }

  void join(int i, int partner) {
    show();
    MovingCircle m = PlainState.copy(world.bodies.get(i));
    describe(m);
    core.join(i, partner, m);
  }

  void joinBoth(MovingCircle a, MovingCircle b) {
    boolean later = core.isMember(a.id) || (b.isCarried() && !a.isCarried());
    joinNext(later ? b.id : a.id, later ? a.id : b.id);
    joinNext(later ? a.id : b.id, later ? b.id : a.id);
  }

  private void joinNext(int i, int other) {
    if (!core.isMember(i) && world.registry.mass(i) < INFINITE) {
      join(i, core.isMember(other) ? other : Index.NONE);
    }
  }

  /** Takes a circle out of contact, as an edit does. */
  void leave(MovingCircle m, double now) {
    if (core != null && core.isMember(m.id)) {
      show();
      m.move(MovingCircle.since(m.t, m.tl, now));
      m.t = now;
      m.tl = 0;
      m.vx = core.velocityX(m.id, now);
      m.vy = core.velocityY(m.id, now);
      m.fall(0, 0);
      core.remove(m.id, now);
    }
  }

  void changed(int code, double now) {
    if (core == null) {
      return;
    }
    show();
    if (!Codes.isCircle(code) || world.registry.mass(Codes.slot(code)) == INFINITE) {
      core.changed(code, now);
    } else if (core.isMember(Codes.slot(code))) {
      describe(world.bodies.get(Codes.slot(code)));
      core.changed();
    }
  }

  /** Shows the circles of infinite mass to the core. */
  private void show() {
    for (MovingCircle m : world.bodies) {
      if (m.id < room && world.registry.mass(m.id) == INFINITE) {
        table.put(m.id, m);
      }
    }
  }

  @Override
  public void membersNear(int slot, double x, double y, double reach, IntList into) {
    for (int i = world.bodies.size() - 1; i >= 0; i--) {
      boolean meet = PlainState.meet(world.registry.filter(i), world.registry.filter(slot));
      if (i != slot && core.isMember(i) && meet) {
        into.add(i);
      }
    }
  }

  @Override
  public void obstaclesNear(int slot, double x, double y, double reach, double now, IntList into) {
    for (int code : world.codes()) {
      if (!Codes.isWall(code) || world.obstacles.walls != null) {
        into.add(code);
      }
    }
    for (MovingCircle m : world.bodies) {
      if (world.registry.contains(m.id) && world.registry.mass(m.id) == INFINITE) {
        into.add(Codes.circle(m.id));
      }
    }
  }

  @Override
  public void flies(int slot) {
    MovingCircle m = world.bodies.get(slot);
    core.put(slot, m);
    world.begin(m);
    world.note(m);
  }

  @Override
  public void frees(int slot, double vx, double vy, int side) {
    MovingCircle m = world.bodies.get(slot);
    core.free(slot, vx, vy, side, m);
    world.begin(m);
    world.note(m);
  }

  @Override
  public void jammed(int slot, int code, int part, double nx, double ny) {
    MovingCircle m = world.bodies.get(slot);
    core.place(slot, m);
    world.rows.addJammed(m, code, part, m.radius, nx, ny, 0);
  }
}
