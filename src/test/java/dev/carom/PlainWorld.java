// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.response.PairResponse;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.util.Index;
import java.util.Collection;
import java.util.List;

/**
 * A world the plain way: no cells, no grid, no calendar, no laziness and no memory but that of
 * which sensors a flight met. Before each event every circle is asked about every obstacle and
 * every other circle, by the public detector, and the first answer happens. What an impact then
 * does is the library's own response. Edits change the flights as {@link World} tells.
 */
public final class PlainWorld extends PlainEdits {

  private final ImpactLog log = new ImpactLog(rows);

  private double first = NEVER;

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
    first = NEVER;
    while (obstacles.nextArrival() < end && log.size() < most) {
      play(obstacles.nextArrival(), most);
      arrive();
    }
    play(end, most);
    rows.sort();
    return log;
  }

  private void play(double end, int most) {
    if (collide) {
      while (log.size() < most && Math.min(find(bodies), contacts.nextTick()) <= end) {
        if (contacts.nextTick() <= time) {
          first = Math.min(first, contacts.nextTick());
          contacts.tick(contacts.nextTick());
        } else {
          happen();
        }
      }
    } else {
      for (MovingCircle m : bodies) {
        while (log.size() < most && Math.min(find(List.of(m)), tickOf(m)) <= end) {
          if (tickOf(m) <= time) {
            first = Math.min(first, tickOf(m));
            lone.tick(m, rows);
            begin(m);
          } else {
            happen();
          }
        }
      }
    }
    now = end;
  }

  private double tickOf(MovingCircle m) {
    return registry.contains(m.id) && m.ticksNext() ? m.due() : NEVER;
  }

  /** The time of the first impact or tick of the last call; infinite if there was none. */
  double firstEvent() {
    return first;
  }

  private void happen() {
    first = Math.min(first, time);
    MovingCircle m = bodies.get(low);
    if (high >= 0) {
      happened();
      meet(m, bodies.get(high));
    } else {
      int code = m.next;
      double vx = m.vx;
      double vy = m.vy;
      if (m.isMember() && !obstacles.isSensor(code)) {
        meetAsMember(m);
        return;
      }
      int result = response.resolve(m, rows);
      if (result == ObstacleResponse.SENSED) {
        met.get(low).put(code, m.cleared);
        return;
      }
      happened();
      begin(m);
      if (result == ObstacleResponse.JOIN) {
        join(m);
        return;
      }
      if (m.vx != vx || m.vy != vy) {
        leaveJamsOfInfinite(m);
      }
      settle(result, m);
      noteInfinite(m);
    }
  }

  private void meetAsMember(MovingCircle m) {
    if (collide) {
      contacts.meet(m.id, time);
    } else {
      lone.meet(m, rows);
      begin(m);
    }
  }

  private void join(MovingCircle m) {
    if (collide) {
      contacts.join(m.id, Index.NONE);
    } else {
      lone.join(m, rows);
      begin(m);
    }
  }

  private void noteInfinite(MovingCircle m) {
    if (registry.mass(m.id) == NEVER) {
      contacts.changed(Codes.circle(m.id), time);
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
    shock.forgetCrushersOf(one);
    shock.forgetCrushersOf(two);
    if (meetAsMembers(a, b)) {
      return;
    }
    takeMomentum(one, Math.max(0, later) + wait);
    takeMomentum(two, Math.max(0, -later) + wait);
    int result = pairs.resolve(one, ofOne, two, ofTwo, wait, true, rows);
    if (result == ObstacleResponse.SENSED) {
      metPairs.put(pair(a, b), wait);
      return;
    }
    keep(a, one);
    keep(b, two);
    noteInfinite(one); // before the other joins: that sees the new flight
    noteInfinite(two);
    if (result == ObstacleResponse.JOIN) {
      contacts.joinBoth(one, two);
    } else {
      settle(result, one, two);
    }
  }

  /** A member flies on until it is told otherwise; other circles begin new flights. */
  private void keep(MovingCircle before, MovingCircle after) {
    if (!before.isMember()) {
      bodies.set(after.id, after);
      begin(after);
    }
  }

  private boolean meetAsMembers(MovingCircle a, MovingCircle b) {
    boolean are =
        (a.isMember() || registry.mass(a.id) == NEVER)
            && (b.isMember() || registry.mass(b.id) == NEVER)
            && (a.isMember() || b.isMember())
            && !pairs.isSilent(a.id, b.id);
    for (MovingCircle m : List.of(a, b)) {
      if (are && m.isMember()) {
        contacts.meet(m.id, time);
      }
    }
    return are;
  }

  private static void takeMomentum(MovingCircle m, double flown) {
    if (m.mode == MovingCircle.AWAKE) {
      m.vx = MovingCircle.velocity(m.px, m.ax, flown);
      m.vy = MovingCircle.velocity(m.py, m.ay, flown);
    }
  }

  /** How long a flight lasted that was known before the wait, which alone lasted so long. */
  private double flown(double before, double waited) {
    return before + wait == wait ? waited : before + wait;
  }

  /** Updates the jams of circles that begin new flights. */
  private void settle(int result, MovingCircle... hit) {
    Collection<MovingCircle> changed = List.of(hit);
    if (result == ObstacleResponse.STUCK) {
      changed = shock.resolve(rows, hit);
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
      if (inert && PairResponse.part(m, other)) {
        m.jam = m.jam.without(code);
      }
    }
  }
}
