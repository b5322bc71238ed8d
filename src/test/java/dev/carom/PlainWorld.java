// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.response.Heap;
import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import java.util.Collection;
import java.util.List;

/**
 * A world the plain way: no cells, no grid, no calendar, no laziness and no memory but that of
 * which sensors a flight met. Before each event every circle is asked about every obstacle and
 * every other circle, by the public detector, and the first answer happens. What an impact then
 * does is the library's own response. Edits change the flights as {@link World} tells.
 */
public final class PlainWorld extends PlainEdits {

  private final ImpactRows rows = new ImpactRows(16);
  private final ImpactLog log = new ImpactLog(rows);

  public PlainWorld(Scene scene) {
    super(scene);
  }

  private PlainWorld(PlainWorld other) {
    super(other);
  }

  PlainWorld copy() {
    return new PlainWorld(this);
  }

  /** The first so many impacts until the given time, in the order of a world's log. */
  public ImpactLog advance(double end, int most) {
    rows.clear();
    if (collide) {
      while (log.size() < most && find(bodies) <= end) {
        happen();
      }
    } else {
      for (MovingCircle m : bodies) {
        while (log.size() < most && find(List.of(m)) <= end) {
          happen();
        }
      }
    }
    rows.sort();
    now = end;
    return log;
  }

  private void happen() {
    MovingCircle m = bodies.get(low);
    if (high >= 0) {
      happened();
      meet(m, bodies.get(high));
    } else {
      int code = m.next;
      double vx = m.vx;
      double vy = m.vy;
      boolean rested = m.isGround();
      int result = response.resolve(m, rows);
      if (result == ObstacleResponse.SENSED) {
        met.get(low).put(code, m.cleared);
      } else {
        happened();
        begin(m);
        if (m.vx != vx || m.vy != vy) {
          leaveJamsOfInfinite(m);
        }
        settle(result, m);
        if (rested) {
          freeThoseOn(m);
        }
      }
    }
  }

  private void happened() {
    lastTail = last == time ? Math.max(lastTail, tail) : tail;
    last = time;
  }

  private void meet(MovingCircle a, MovingCircle b) {
    MovingCircle one = copy(a);
    MovingCircle two = copy(b);
    double later = later(one, two);
    bringTogether(one, two);
    double ofOne = flown(Math.max(0, later), one.advance(wait));
    double ofTwo = flown(Math.max(0, -later), two.advance(wait));
    cluster.forgetCrushersOf(one);
    cluster.forgetCrushersOf(two);
    int result = pairs.resolve(one, ofOne, two, ofTwo, wait, true, rows);
    if (result == ObstacleResponse.SENSED) {
      metPairs.put(pair(a, b), wait);
    } else {
      bodies.set(a.id, one);
      bodies.set(b.id, two);
      begin(one);
      begin(two);
      settle(result, one, two);
      if (a.isGround()) {
        freeThoseOn(one);
      } else if (b.isGround()) {
        freeThoseOn(two);
      }
      if (one.slowContacts >= Heap.TRIAL || two.slowContacts >= Heap.TRIAL) {
        change(heap.rest(rows, copy(one), copy(two)));
      }
    }
  }

  /** How long a flight lasted that was known before the wait, which alone lasted so long. */
  private double flown(double before, double waited) {
    return before + wait == wait ? waited : before + wait;
  }

  /** Lets the circles fall that one held which rested, unless it still does. */
  private void freeThoseOn(MovingCircle m) {
    if (gravity.acts() && collide && !m.isGround()) {
      change(heap.free(copy(m)));
    }
  }

  /** Circles begin new flights, as a heap has it. */
  private void change(Collection<MovingCircle> changed) {
    for (MovingCircle m : changed) {
      bodies.set(m.id, m);
      begin(m);
    }
    changed.forEach(this::revive);
  }

  /** Updates the jams of circles that begin new flights. */
  private void settle(int result, MovingCircle... hit) {
    Collection<MovingCircle> changed = List.of(hit);
    if (result == ObstacleResponse.STUCK && (collide || obstacles.areMoving())) {
      changed = cluster.resolve(rows, hit);
      for (MovingCircle m : changed) {
        bodies.set(m.id, m);
        begin(m);
      }
    }
    changed.forEach(this::revive);
  }

  private void revive(MovingCircle m) {
    for (MovingCircle other : bodies) {
      int code = Codes.circle(other.id);
      boolean inert = m.jam != null && m.jam.makesInert(code);
      if (inert && pairs.part(m, other)) {
        m.jam = m.jam.without(code);
      }
    }
  }
}
