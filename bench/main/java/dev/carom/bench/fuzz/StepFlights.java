// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.ObstacleKind;
import dev.carom.Timeline;
import dev.carom.World;
import java.util.ArrayList;
import java.util.List;

/** The flights of one step, from its log and its timeline; each must lead to the next one. */
final class StepFlights {

  private final World world;
  private final Timeline timeline;
  private final double start;
  private final Rounding rounding;

  StepFlights(World world, Timeline timeline, double start, Rounding rounding) {
    this.world = world;
    this.timeline = timeline;
    this.start = start;
    this.rounding = rounding;
  }

  /** Of all circles, one list each; none for those that are out of the range of doubles. */
  List<List<Flight>> all() throws FindingException {
    List<List<Double>> moments = moments();
    List<List<Flight>> flights = new ArrayList<>();
    for (int i = 0; i < moments.size(); i++) {
      flights.add(world.contains(ObstacleKind.CIRCLE, i) ? of(i, moments.get(i)) : List.of());
    }
    return flights;
  }

  /** The start of the step, each circle's impacts, and the end. */
  private List<List<Double>> moments() {
    List<List<Double>> moments = new ArrayList<>();
    for (int i = 0; i < world.idLimit(ObstacleKind.CIRCLE); i++) {
      moments.add(new ArrayList<>(List.of(start)));
    }
    ImpactLog log = world.impacts();
    for (int row = 0; row < log.size(); row++) {
      moments.get(log.circle(row)).add(log.time(row));
      if (log.kind(row) == ObstacleKind.CIRCLE) {
        moments.get(log.id(row)).add(log.time(row));
      }
    }
    moments.forEach(of -> of.add(world.now()));
    return moments;
  }

  private List<Flight> of(int i, List<Double> moments) throws FindingException {
    List<Flight> flights = new ArrayList<>();
    for (int k = 1; k < moments.size(); k++) {
      double from = moments.get(k - 1);
      double to = moments.get(k);
      if (to > from && !isBurst(moments, k)) {
        Flight flight = flight(i, from, to);
        checkContinuous(flight);
        if (flight.isFinite()) {
          flights.add(flight);
        }
      }
    }
    return flights;
  }

  /**
   * Whether three impacts or more have the stored time of moment k. Bumpers then may have driven
   * the circle any way within one ulp of the clock, and the timeline tells its last place only.
   */
  private static boolean isBurst(List<Double> moments, int k) {
    return k + 2 < moments.size() && moments.get(k + 2).equals(moments.get(k));
  }

  private Flight flight(int i, double from, double to) {
    return new Flight(
        i,
        timeline.radius(i, from),
        from,
        to,
        timeline.x(i, from),
        timeline.y(i, from),
        timeline.x(i, to),
        timeline.y(i, to),
        timeline.vx(i, from),
        timeline.vy(i, from),
        Math.max(speed(i, from), speed(i, to)));
  }

  private double speed(int i, double t) {
    return Math.hypot(timeline.vx(i, t), timeline.vy(i, t));
  }

  private void checkContinuous(Flight f) throws FindingException {
    double slack = rounding.of(f);
    double dt = f.to() - f.from();
    double jumpX = Math.abs(Math.fma(f.vx(), dt, f.px()) - f.qx());
    double jumpY = Math.abs(Math.fma(f.vy(), dt, f.py()) - f.qy());
    boolean whole = !Double.isNaN(f.px() + f.py() + f.vx() + f.vy());
    if (!whole || (f.isFinite() && !(jumpX <= slack && jumpY <= slack))) {
      throw new FindingException("the flight is not continuous: " + f + ", bound " + slack);
    }
  }
}
