// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.ExactTime;
import dev.carom.internal.search.BoxTree;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Filter;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.sweep.ParabolaDiskSweep;
import dev.carom.internal.sweep.ParabolaHit;
import dev.carom.internal.util.IntList;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/** Queries about the circles of a world, by their slots. */
public final class CircleQueries {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** In units of the terms of a position: far more than its rounding. */
  private static final double ROUNDING = 0x1p-40;

  private final CircleTable circles;
  private final CircleRegistry registry;
  private final CircleIndex index;
  private final IntList found = new IntList();
  private final BoxTree.Outside box = new BoxTree.Outside();
  private final Hit hit = new Hit();

  /**
   * Makes queries about circles.
   *
   * @param indexed whether an index may be made; if not, each circle is tested
   */
  public CircleQueries(CircleTable circles, CircleRegistry registry, boolean indexed) {
    this.circles = circles;
    this.registry = registry;
    index = new CircleIndex(circles, registry, indexed);
  }

  /** Notes that circles have moved, or were edited. */
  public void forget() {
    index.forget();
  }

  /** Counts questions that are about to be asked, see {@link CircleIndex#expect}. */
  public void expect(int questions, double now) {
    index.expect(questions, now);
  }

  // The first impact.

  /**
   * Finds the first contact of a cast with any circle but sensors, if it is exactly earlier than a
   * contact with an obstacle that was found before. Of exactly simultaneous ones the smallest code
   * is first.
   *
   * @param m the circle that is cast, at the start; it holds the first contact with an obstacle
   *     until maxTime, if there is one, and receives the answer
   * @param tracer the one that found the contact with the obstacle
   * @param maxTime the end of the window, counted from now
   */
  public void first(MovingCircle m, Tracer tracer, double maxTime, double now) {
    if (index.tree() == null || circles.allowsGravity()) {
      LiveCodes present = registry.present();
      for (int i = 0; i < present.size(); i++) {
        int slot = present.get(i);
        if (index.isThere(slot, now)) {
          consider(m, slot, tracer, maxTime, now);
        }
      }
    } else if (index.tree().size() > 0) {
      walk(m, tracer, maxTime, now);
    }
  }

  /**
   * Considers the circles along the path, piece by piece. A circle that is hit by the end of a
   * piece is now no further from it than it moves until then.
   */
  private void walk(MovingCircle m, Tracer tracer, double maxTime, double now) {
    index.beginCast();
    BoxTree tree = index.tree();
    double width = tree.side(BoxTree.RIGHT) - tree.side(BoxTree.LEFT);
    double height = tree.side(BoxTree.TOP) - tree.side(BoxTree.BOTTOM);
    double piece = m.radius + Math.sqrt(width / tree.size() * height);
    double wx = index.fastestX();
    double wy = index.fastestY();
    double speed = Math.abs(m.vx) + Math.abs(m.vy) + wx + wy;
    int most = 16 + 4 * (int) Math.sqrt(tree.size());
    double from = 0;
    for (int pieces = 0; from <= end(m, maxTime) && from < NEVER; pieces++) {
      double to = pieces < most ? from + (piece + (wx + wy) * from) / speed : NEVER;
      double ahead = Math.min(to, end(m, maxTime));
      double rounding = ROUNDING * (Math.abs(m.x) + Math.abs(m.y) + tree.extent + speed * ahead);
      double reachX = m.radius + wx * ahead + rounding;
      double reachY = m.radius + wy * ahead + rounding;
      double x0 = m.x + m.vx * from;
      double y0 = m.y + m.vy * from;
      double x1 = m.x + m.vx * ahead;
      double y1 = m.y + m.vy * ahead;
      found.clear();
      tree.find(
          box.set(
              Math.min(x0, x1) - reachX,
              Math.min(y0, y1) - reachY,
              Math.max(x0, x1) + reachX,
              Math.max(y0, y1) + reachY),
          found);
      for (int k = 0; k < found.size(); k++) {
        if (index.isNew(found.get(k))) {
          consider(m, found.get(k), tracer, maxTime, now);
        }
      }
      from = leaves(m, x1, y1, reachX, reachY) ? NEVER : to;
    }
  }

  /** Whether a cast at (x, y) is beyond all circles, and no circle can come up with it. */
  private boolean leaves(MovingCircle m, double x, double y, double reachX, double reachY) {
    BoxTree tree = index.tree();
    return (m.vx >= index.fastestX() && x - reachX > tree.side(BoxTree.RIGHT))
        || (m.vx <= -index.fastestX() && x + reachX < tree.side(BoxTree.LEFT))
        || (m.vy >= index.fastestY() && y - reachY > tree.side(BoxTree.TOP))
        || (m.vy <= -index.fastestY() && y + reachY < tree.side(BoxTree.BOTTOM));
  }

  /** The time beyond which no contact is of interest. */
  private static double end(MovingCircle m, double maxTime) {
    return m.next == MovingCircle.NOTHING ? maxTime : m.cleared;
  }

  /** Keeps the contact with a circle if it is the first one. */
  private void consider(MovingCircle m, int slot, Tracer tracer, double maxTime, double now) {
    if (registry.isSensor(slot) || !Filter.meet(m.filter, registry.filter(slot))) {
      return;
    }
    double x = circles.x(slot, now);
    double y = circles.y(slot, now);
    double r = circles.radius(slot);
    if (m.radius + r == 0) {
      return; // two points do not meet
    }
    double vx = circles.vx(slot, now);
    double vy = circles.vy(slot, now);
    if (isFalling(slot)) {
      considerFalling(m, slot, maxTime, now);
      return;
    }
    int contact = DiskSweep.contact(m.x, m.y, m.radius, m.vx, m.vy, x, y, r, vx, vy);
    double limit = end(m, maxTime);
    // A time that rounds to the limit is exactly before the next double.
    double end = Math.nextUp(limit);
    double t = DiskSweep.time(contact, m.x, m.y, m.radius, m.vx, m.vy, x, y, r, vx, vy, end);
    if (t > limit || t == NEVER || (t == limit && !isFirst(m, slot, contact, tracer, t, now))) {
      return;
    }
    m.next = Codes.circle(slot);
    m.contact = contact;
    m.cleared = t;
  }

  /** The same for a circle that falls; of equal rounded times the smallest code is first. */
  private void considerFalling(MovingCircle m, int slot, double maxTime, double now) {
    double t =
        ParabolaDiskSweep.time(
            m.x,
            m.y,
            m.radius,
            m.vx,
            m.vy,
            -circles.gx(slot),
            -circles.gy(slot),
            circles.x(slot, now),
            circles.y(slot, now),
            circles.radius(slot),
            circles.vx(slot, now),
            circles.vy(slot, now),
            end(m, maxTime));
    boolean none = m.next == MovingCircle.NOTHING;
    if (t < NEVER && (none || t < m.cleared || Codes.circle(slot) < m.next)) {
      m.next = Codes.circle(slot);
      m.contact = t == 0 ? Contact.NOW : Contact.LATER;
      m.cleared = t;
    }
  }

  /** Whether a contact is before the limit, with which its rounded time is equal. */
  private boolean isFirst(
      MovingCircle m, int slot, int contact, Tracer tracer, double limit, double now) {
    ExactTime time = exactTime(m, slot, contact, now);
    if (m.next == MovingCircle.NOTHING) {
      return time.compare(ExactTime.of(limit)) <= 0;
    }
    if (Codes.isCircle(m.next) && isFalling(Codes.slot(m.next))) {
      return Codes.circle(slot) < m.next;
    }
    int order =
        time.compare(
            Codes.isCircle(m.next)
                ? exactTime(m, Codes.slot(m.next), m.contact, now)
                : tracer.exactTime(m));
    return order != 0 ? order < 0 : Codes.circle(slot) < m.next;
  }

  private boolean isFalling(int slot) {
    return circles.gx(slot) != 0 || circles.gy(slot) != 0;
  }

  private ExactTime exactTime(MovingCircle m, int slot, int contact, double now) {
    return DiskSweep.exactTime(
        contact,
        m.x,
        m.y,
        m.radius,
        m.vx,
        m.vy,
        circles.x(slot, now),
        circles.y(slot, now),
        circles.radius(slot),
        circles.vx(slot, now),
        circles.vy(slot, now));
  }

  /** The hit of a cast on the circle that it found first; always the same object. */
  public Hit hit(MovingCircle m, double now) {
    int slot = Codes.slot(m.next);
    if (isFalling(slot)) {
      return ParabolaHit.ofDisks(
              m.x,
              m.y,
              m.radius,
              m.vx,
              m.vy,
              -circles.gx(slot),
              -circles.gy(slot),
              circles.x(slot, now),
              circles.y(slot, now),
              circles.radius(slot),
              circles.vx(slot, now),
              circles.vy(slot, now),
              m.cleared)
          .moved(
              MovingCircle.place(0, 0, circles.gx(slot), m.cleared),
              MovingCircle.place(0, 0, circles.gy(slot), m.cleared));
    }
    return hit.ofDisks(
        m.x,
        m.y,
        m.radius,
        m.vx,
        m.vy,
        circles.x(slot, now),
        circles.y(slot, now),
        circles.radius(slot),
        circles.vx(slot, now),
        circles.vy(slot, now),
        m.contact,
        m.cleared);
  }

  // Circles near a point, a disk or a box.

  /**
   * The slot of the circle nearest to a point, of equally near ones the first; or NONE.
   *
   * @param seen the slots that count
   */
  public int nearest(double x, double y, double now, IntPredicate seen) {
    index.expect(1, now);
    NearestItem nearest =
        new NearestItem(
            seen,
            slot ->
                Proximity.distance(
                    circles.x(slot, now), circles.y(slot, now), circles.radius(slot), x, y));
    if (index.tree() == null) {
      slots(now).forEach(nearest::look);
    } else {
      nearest.search(index.tree(), x, y);
    }
    return nearest.item();
  }

  /**
   * The slots of circles that overlap a disk, ascending.
   *
   * @param seen the slots that count
   */
  public int[] overlapping(double x, double y, double r, double now, IntPredicate seen) {
    return find(
        Proximity.outside(x, y, r),
        now,
        slot ->
            seen.test(slot)
                && Proximity.overlaps(
                    circles.x(slot, now), circles.y(slot, now), circles.radius(slot), x, y, r));
  }

  /**
   * The slots of circles that overlap a box, ascending.
   *
   * @param seen the slots that count
   */
  public int[] overlapping(double[] box, double now, IntPredicate seen) {
    return find(
        Proximity.outside(box),
        now,
        slot ->
            seen.test(slot)
                && Proximity.overlaps(
                    circles.x(slot, now), circles.y(slot, now), circles.radius(slot), box));
  }

  /** The slots of circles that pass a test, which none outside of a box does. */
  private int[] find(BoxTree.Outside box, double now, IntPredicate test) {
    index.expect(1, now);
    found.clear();
    if (index.tree() == null) {
      slots(now).forEach(found::add);
    } else {
      index.tree().find(box, found);
    }
    return found.filtered(test);
  }

  private IntStream slots(double now) {
    return registry.present().stream(slot -> !index.isThere(slot, now));
  }
}
