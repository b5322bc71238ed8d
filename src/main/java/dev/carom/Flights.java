// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The flights of circles that ignore each other. Each circle is alone, so each is advanced to the
 * end of a step at once, without a queue; one comparison tells that nothing happens to it in a
 * step.
 */
final class Flights implements Engine {

  /** Circles that a step may advance before the journal grows. */
  private static final int JOURNAL = 1024;

  /** Impacts in one call, shared by all circles; see {@link World}. */
  static final int IMPACTS_PER_CALL = 4_000_000;

  private static final int LEAST_IMPACTS_PER_CALL = 10_000;

  private final Roster roster;
  private final Circles circles;
  private final Surroundings surroundings;
  private final ObstacleResponse response;
  private final ImpactLog log;
  private final Journal journal;
  private boolean unfinished;

  /** Null unless flights are recorded. */
  private Timeline timeline;

  Flights(Scene scene, Roster roster, Machinery machinery, ImpactLog log) {
    this.roster = roster;
    this.log = log;
    surroundings = new Surroundings(scene, machinery);
    int count = scene.circleCount();
    circles = new Circles(count);
    journal = new Journal(Math.min(count, JOURNAL), Circles.STATE, Circles.CODES);
    response = new ObstacleResponse(surroundings.obstacles, roster.patience());
    for (int i = 0; i < count; i++) {
      circles.start(scene, i);
      surroundings.extend(circles.mover, 0);
      circles.store(i);
    }
  }

  @Override
  public Circles circles() {
    return circles;
  }

  @Override
  public String model() {
    return surroundings.model().toString();
  }

  /**
   * Advances all circles to the given time, or, if one of them makes as many impacts as allowed
   * before, to the time of the last of these.
   *
   * @return the time reached
   */
  @Override
  public double advance(double end) {
    surroundings.prepare(circles);
    response.setPatience(roster.patience());
    journal.clear();
    unfinished = false;
    double reached = end;
    double goal;
    do {
      goal = reached;
      reached = pass(goal);
      if (reached < goal) {
        journal.restore(circles.due, circles.jams, circles.state, circles.codes);
        log.clear();
        if (timeline != null) {
          timeline.undo();
        }
      }
    } while (reached < goal);
    return reached;
  }

  @Override
  public boolean unfinished() {
    return unfinished;
  }

  private double pass(double end) {
    int allowance =
        Math.max(LEAST_IMPACTS_PER_CALL, IMPACTS_PER_CALL / Math.max(1, roster.count()));
    double[] due = circles.due;
    for (int i = 0; i < due.length; i++) {
      if (due[i] <= end) {
        journal.save(i, due[i], circles.jam(i), circles.state, circles.codes);
        circles.load(i);
        boolean spent = fly(circles.mover, allowance, end);
        circles.store(i);
        if (spent) {
          unfinished = true;
          if (circles.mover.t < end) {
            return circles.mover.t;
          }
        }
      }
    }
    return end;
  }

  /** Resolves the mover's impacts until the given time; tells whether the allowance was spent. */
  private boolean fly(Mover m, int allowance, double end) {
    int impacts = 0;
    do {
      if (m.next == Mover.NOTHING) {
        surroundings.extend(m, end - m.t);
      } else {
        if (impacts == allowance) {
          return true;
        }
        if (response.resolve(m, log) && timeline != null) {
          timeline.note(m);
        }
        impacts++;
      }
    } while (m.due() <= end);
    return false;
  }

  @Override
  public Surroundings surroundings() {
    return surroundings;
  }

  @Override
  public void fly(Mover m) {
    if (m.id == circles.count) {
      circles.add();
    }
    surroundings.setRadius(m.id, m.radius);
    circles.store(m.id, m);
    if (timeline != null) {
      timeline.add(m);
    }
  }

  @Override
  public void remove(int i) {
    circles.due[i] = Double.POSITIVE_INFINITY;
  }

  @Override
  public void record(Timeline timeline) {
    this.timeline = timeline;
    for (int i = 0; i < circles.count && timeline != null; i++) {
      if (roster.contains(i)) {
        circles.load(i);
        timeline.add(circles.mover);
      }
    }
  }

  @Override
  public FlightStates save() {
    FlightStates states = new FlightStates(circles.count);
    for (int i = 0; i < circles.count; i++) {
      circles.load(i);
      surroundings.save(circles.mover, states);
    }
    return states;
  }

  @Override
  public void restore(FlightStates flights, double now) {
    circles.clear();
    for (int i = 0; i < flights.count(); i++) {
      flights.get(i, circles.mover);
      circles.add();
      surroundings.setRadius(i, circles.mover.radius);
      circles.store(i);
      if (!roster.contains(i)) {
        remove(i);
      }
    }
  }

  @Override
  public void forget(int code) {
    int sensed = surroundings.sensedBefore(code);
    for (int i = 0; i < circles.count; i++) {
      circles.load(i);
      if (roster.contains(i) && circles.mover.forget(code, sensed)) {
        circles.store(i);
      }
    }
  }

  @Override
  public void appeared(int code, double now) {
    Mover m = circles.mover;
    for (int i = 0; i < circles.count; i++) {
      if (roster.contains(i)) {
        circles.load(i);
        if (surroundings.meets(m, code)) {
          m.restart(now);
          fly(m);
        }
      }
    }
  }
}
