// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Obstacle;
import dev.carom.Timeline;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.Sides;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.Set;

/**
 * Whether flights respect the obstacles that turn: at some places of each flight, none comes nearer
 * than the radius, or than it was at its start if that was less.
 */
final class TurnCheck {

  private static final int PLACES = 32;

  /** In radii: circles in contact under gravity may overlap by so much. */
  private static final double IN_CONTACT = 1e-9;

  private final World world;
  private final Rounding rounding;
  private final PassedOver passed;
  private final Set<String> turning;
  private final Timeline timeline;

  TurnCheck(
      World world, Rounding rounding, PassedOver passed, Set<String> turning, Timeline timeline) {
    this.world = world;
    this.rounding = rounding;
    this.passed = passed;
    this.turning = turning;
    this.timeline = timeline;
  }

  void check(List<List<Flight>> flights) throws FindingException {
    if (turning.isEmpty()) {
      return;
    }
    for (List<Flight> of : flights) {
      for (Flight f : of) {
        check(f, Kind.LINE);
        check(f, Kind.PEG);
      }
    }
  }

  private void check(Flight f, Kind kind) throws FindingException {
    for (int id : world.ids(kind)) {
      if (turning.contains(Solid.name(kind, id))
          && Solid.isSolid(world, f, kind, id)
          && !world.traits(kind, id).oneWay()
          && !passed.mayPass(f)
          && !isInside(timeline.shape(kind, id, f.from()), f)) {
        check(f, kind, id);
      }
    }
  }

  private void check(Flight f, Kind kind, int id) throws FindingException {
    Obstacle shape = timeline.shape(kind, id, f.from());
    double reach = f.radius() + (shape instanceof Circle peg ? peg.radius() : 0);
    double slack =
        rounding.of(f) + (world.gravity().equals(Vec2.ZERO) ? 0 : IN_CONTACT * f.radius());
    double limit = Crossings.limit(f, reach, distance(shape, f.px(), f.py()), slack);
    for (int k = 1; k <= PLACES; k++) {
      double t = k == PLACES ? f.to() : f.from() + k * ((f.to() - f.from()) / PLACES);
      double distance = distance(timeline.shape(kind, id, t), f.x(t), f.y(t));
      if (distance < limit) {
        throw new FindingException(
            "%s comes nearer to %s, which turns, than %s: %s at %s"
                .formatted(f, Solid.name(kind, id), limit, distance, t));
      }
    }
  }

  private static boolean isInside(Obstacle shape, Flight f) {
    if (!Solid.isPolygon(shape)) {
      return false;
    }
    Path2D polygon = new Path2D.Double();
    for (Line side : Sides.of(shape)) {
      if (polygon.getCurrentPoint() == null) {
        polygon.moveTo(side.ax(), side.ay());
      }
      polygon.lineTo(side.bx(), side.by());
    }
    return polygon.contains(f.px(), f.py());
  }

  /** How far a place is from the spine of a thing. */
  private static double distance(Obstacle shape, double x, double y) {
    if (shape instanceof Circle peg) {
      return Math.hypot(x - peg.x(), y - peg.y());
    }
    double least = Double.POSITIVE_INFINITY;
    for (Line side : Sides.of(shape)) {
      Vec2 offset = Solid.offset(side, x, y);
      least = Math.min(least, Math.hypot(offset.x(), offset.y()));
    }
    return least;
  }
}
