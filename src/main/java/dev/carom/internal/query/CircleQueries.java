// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Filter;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.util.Index;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/** Queries about the circles of a world, by their slots. */
public final class CircleQueries {

  private final CircleTable circles;
  private final CircleRegistry registry;

  public CircleQueries(CircleTable circles, CircleRegistry registry) {
    this.circles = circles;
    this.registry = registry;
  }

  /**
   * The first contact of a cast with any circle but sensors, or with an obstacle found before:
   * exactly the earliest one. Of exactly simultaneous ones circles come last.
   *
   * @param m the circle that is cast, at the start
   * @param before a contact with an obstacle until maxTime, null for none
   * @param maxTime the end of the window, counted from now
   * @return the contact, null if there is none until maxTime
   */
  public Candidate first(MovingCircle m, Candidate before, double maxTime, double now) {
    Candidate first = before;
    LiveCodes present = registry.present();
    for (int i = 0; i < present.size(); i++) {
      int slot = present.get(i);
      if (isThere(slot, now)
          && Filter.meet(m.filter, registry.filter(slot))
          && !registry.isSensor(slot)) {
        Candidate other = candidate(m, slot, first == null ? maxTime : first.time(), now);
        if (other != null && (first == null ? other.isWithin(maxTime) : other.isBefore(first))) {
          first = other;
        }
      }
    }
    return first;
  }

  /** The contact with a circle, null for none whose rounded time is at most a limit. */
  private Candidate candidate(MovingCircle m, int slot, double limit, double now) {
    double x = circles.x(slot, now);
    double y = circles.y(slot, now);
    double r = circles.radius(slot);
    double vx = circles.vx(slot);
    double vy = circles.vy(slot);
    int contact = DiskSweep.contact(m.x, m.y, m.radius, m.vx, m.vy, x, y, r, vx, vy);
    // What rounds to the limit is exactly before the next double.
    double end = Math.nextUp(limit);
    double t = DiskSweep.time(contact, m.x, m.y, m.radius, m.vx, m.vy, x, y, r, vx, vy, end);
    if (t > limit || t == Double.POSITIVE_INFINITY) {
      return null;
    }
    return new Candidate(
        Codes.circle(slot),
        contact,
        t,
        () -> DiskSweep.exactTime(contact, m.x, m.y, m.radius, m.vx, m.vy, x, y, r, vx, vy),
        () -> Hit.ofDisks(m.x, m.y, m.radius, m.vx, m.vy, x, y, r, vx, vy, contact, t));
  }

  /**
   * The slot of the circle nearest to a point, of equally near ones the first; or NONE.
   *
   * @param seen the slots that count
   */
  public int nearest(double x, double y, double now, IntPredicate seen) {
    double least = Double.POSITIVE_INFINITY;
    int nearest = Index.NONE;
    for (int slot : slots(now).filter(seen).toArray()) {
      double distance =
          Proximity.distance(
              circles.x(slot, now), circles.y(slot, now), circles.radius(slot), x, y);
      if (nearest == Index.NONE || distance < least) {
        least = distance;
        nearest = slot;
      }
    }
    return nearest;
  }

  /** The slots of circles that overlap a disk. */
  public IntStream overlapping(double x, double y, double r, double now) {
    return slots(now)
        .filter(
            slot ->
                Proximity.overlaps(
                    circles.x(slot, now), circles.y(slot, now), circles.radius(slot), x, y, r));
  }

  /** The slots of circles that overlap a box. */
  public IntStream overlapping(double[] box, double now) {
    return slots(now)
        .filter(
            slot ->
                Proximity.overlaps(
                    circles.x(slot, now), circles.y(slot, now), circles.radius(slot), box));
  }

  private IntStream slots(double now) {
    return registry.present().stream(slot -> !isThere(slot, now));
  }

  /** Whether a circle is there, and not beyond the range of doubles. */
  private boolean isThere(int slot, double now) {
    return registry.contains(slot)
        && Math.abs(circles.x(slot, now)) <= Double.MAX_VALUE
        && Math.abs(circles.y(slot, now)) <= Double.MAX_VALUE;
  }
}
