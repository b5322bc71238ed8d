// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.util.IntList;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/** Queries about the circles of a world, by their slots. */
public final class CircleQueries {

  private final CircleTable circles;
  private final CircleRegistry registry;
  private final CircleIndex index;
  private final IntList found = new IntList();
  private final FirstCircle first;

  /**
   * Makes queries about circles.
   *
   * @param indexed whether an index may be made; if not, each circle is tested
   */
  public CircleQueries(CircleTable circles, CircleRegistry registry, boolean indexed) {
    this.circles = circles;
    this.registry = registry;
    index = new CircleIndex(circles, registry, indexed);
    first = new FirstCircle(circles, registry, index);
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
   * is first. A circle of the world does not hit itself.
   *
   * @param m the circle that is cast, at the start; it holds the first contact with an obstacle
   *     until maxTime, if there is one, and receives the answer
   * @param tracer the one that found the contact with the obstacle
   * @param maxTime the end of the window, counted from now
   */
  public void first(MovingCircle m, Tracer tracer, double maxTime, double now) {
    first.find(m, tracer, maxTime, now, true);
  }

  /** The same for a leg of a path, which starts at a later time. */
  void firstOfLeg(MovingCircle m, Tracer tracer, double maxTime, double start) {
    first.find(m, tracer, maxTime, start, false);
  }

  /** The hit of a cast on the circle that it found first; often the same object. */
  public Hit hit(MovingCircle m, double now) {
    return first.hit(m, now);
  }

  // Circles near a point or a region.

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
   * The slots of circles that overlap a region, ascending.
   *
   * @param seen the slots that count
   */
  public int[] overlapping(Region region, double now, IntPredicate seen) {
    index.expect(1, now);
    found.clear();
    if (index.tree() == null) {
      slots(now).forEach(found::add);
    } else {
      index.tree().find(region.outside, found);
    }
    return found.filtered(
        slot ->
            seen.test(slot)
                && region.overlapsDisk(
                    circles.x(slot, now), circles.y(slot, now), circles.radius(slot)));
  }

  private IntStream slots(double now) {
    return registry.present().stream(slot -> !index.isThere(slot, now));
  }
}
