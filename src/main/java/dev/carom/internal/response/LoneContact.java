// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.ContactRow;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;

/**
 * Contact of circles that ignore each other: each is a member on its own, with its own clock. One
 * {@link ContactCore} serves them in turn. What it knows of a circle stands in {@link
 * MovingCircle#contactRow} between.
 */
public final class LoneContact implements ContactHost {

  /** Finds obstacles near a circle. */
  public interface Nearby {

    /**
     * Adds the codes of the obstacles that may be nearer to a circle than a given distance.
     *
     * @param m the circle, at its place now
     */
    void obstaclesNear(MovingCircle m, double reach, double now, IntList into);
  }

  private static final int SLOT = 0;

  private final ObstacleTable obstacles;
  private final CircleRegistry registry;
  private final Gravity gravity;
  private final Nearby nearby;
  private final MovingCircle place = new MovingCircle();

  /** Null until a circle joins, and while gravity is another one. */
  private ContactCore core;

  private double gx;
  private double gy;

  // The present circle, the time, the log, and whether it is free again.
  private MovingCircle present;
  private double now;
  private ImpactRows log;
  private boolean isFree;

  public LoneContact(
      ObstacleTable obstacles, CircleRegistry registry, Gravity gravity, Nearby nearby) {
    this.obstacles = obstacles;
    this.registry = registry;
    this.gravity = gravity;
    this.nearby = nearby;
  }

  /** Notes that an obstacle comes, goes or changes. */
  public void changed() {
    if (core != null) {
      core.changedParts();
    }
  }

  /** Whether an obstacle is so near to a member that it may touch it. */
  public boolean isNear(MovingCircle m, int code, double now) {
    begin(m, now, null);
    double since = MovingCircle.since(m.t, m.tl, now);
    return core.isNear(code, m.xAfter(since), m.yAfter(since), m.radius, now);
  }

  /** Takes a member out of contact now; it has its momentum then. */
  public void leave(MovingCircle m, double now) {
    double since = MovingCircle.since(m.t, m.tl, now);
    boolean awake = m.mode == MovingCircle.AWAKE;
    m.move(since);
    m.t = now;
    m.tl = 0;
    m.vx = awake ? MovingCircle.velocity(m.px, m.ax, since) : m.vx;
    m.vy = awake ? MovingCircle.velocity(m.py, m.ay, since) : m.vy;
    m.fall(0, 0);
  }

  /** Lets a circle join, where it is. */
  public void join(MovingCircle m, ImpactRows log) {
    begin(m, m.t, log);
    core.join(SLOT, Index.NONE, m);
    take(m);
  }

  /** Ends the tick of a member. */
  public void tick(MovingCircle m, ImpactRows log) {
    begin(m, Math.max(m.t, m.contactRow[ContactRow.END]), log);
    restore(m);
    core.tick(now);
    take(m);
  }

  /** A frozen circle meets something that moves, after so long. */
  public void meet(MovingCircle m, ImpactRows log) {
    begin(m, m.after(m.cleared), log);
    restore(m);
    core.meet(SLOT, now);
    core.tick(now);
    take(m);
  }

  private void begin(MovingCircle m, double now, ImpactRows log) {
    if (core == null || gx != gravity.x || gy != gravity.y) {
      gx = gravity.x;
      gy = gravity.y;
      core = new ContactCore(obstacles, null, null, this, 1, gx, gy); // SLOT is in no registry
    }
    core.describe(SLOT, m.radius, 1, m.restitution, m.filter);
    place.id = m.id;
    place.radius = m.radius;
    present = m;
    this.now = now;
    this.log = log;
    isFree = false;
  }

  private void restore(MovingCircle m) {
    core.restore(SLOT, m);
    core.restored(registry, now);
  }

  /** Gives the circle the flight that it has now. */
  private void take(MovingCircle m) {
    if (!isFree) {
      core.put(SLOT, m);
      m.t = now; // a jammed one stands there since an earlier tick
      core.changed(); // the list is made anew in each tick
      m.contactRow = core.save(SLOT, registry);
    }
    core.clear();
  }

  @Override
  public void membersNear(int slot, double x, double y, double reach, IntList into) {
    // They ignore each other.
  }

  @Override
  public void obstaclesNear(int slot, double x, double y, double reach, double now, IntList into) {
    place.x = x;
    place.y = y;
    nearby.obstaclesNear(place, reach, now, into);
  }

  @Override
  public void flies(int slot) {
    // The flight is read when the tick is done.
  }

  @Override
  public void frees(int slot, double vx, double vy, int side) {
    isFree = true;
    core.free(slot, vx, vy, side, present);
  }

  @Override
  public void jammed(int slot, int code, int part, double nx, double ny) {
    core.place(slot, present);
    log.addJammed(present, code, part, present.radius, nx, ny, 0);
  }
}
