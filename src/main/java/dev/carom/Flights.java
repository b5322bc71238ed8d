// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The flights of circles that ignore each other. Each circle is alone, so each is advanced to the
 * end of a step at once, without a queue; one comparison tells that nothing happens to it in a
 * step.
 */
final class Flights extends Engine {

  /** Circles that a step may advance before the journal grows. */
  private static final int JOURNAL = 1024;

  /** Impacts in one call, shared by all circles; see {@link World}. */
  static final int IMPACTS_PER_CALL = 4_000_000;

  private static final int LEAST_IMPACTS_PER_CALL = 10_000;

  private final Journal journal;
  private final DueCircles ahead;

  Flights(Scene scene, Roster roster, Machinery machinery, ImpactLog log) {
    super(scene, roster, new Circles(scene.circleCount()), machinery, log);
    int count = circles.count;
    ahead = new DueCircles(circles, surroundings);
    journal = new Journal(Math.min(count, JOURNAL));
    for (int i = 0; i < count; i++) {
      circles.start(scene, i);
      surroundings.extend(circles.mover, 0);
      circles.store(i);
    }
  }

  @Override
  String model() {
    return surroundings.model(false).toString();
  }

  /**
   * Advances all circles to the given time, or, if one of them makes as many impacts as allowed
   * before, to the time of the last of these.
   *
   * @return the time reached
   */
  @Override
  double advance(double end) {
    prepare();
    journal.clear();
    unfinished = false;
    double reached = end;
    double goal;
    do {
      goal = reached;
      reached = pass(goal);
      if (reached < goal) {
        journal.restore(circles);
        log.clear();
        if (timeline != null) {
          timeline.undo();
        }
      }
    } while (reached < goal);
    return reached;
  }

  /** Advances all to the given time, or to where the first of those stands that spent theirs. */
  private double pass(double goal) {
    int allowance =
        Math.max(LEAST_IMPACTS_PER_CALL, IMPACTS_PER_CALL / Math.max(1, roster.count()));
    ExactWork work = ExactWork.ofThread();
    Agenda due = circles.due;
    double end = goal;
    boolean many = circles.count >= DueCircles.LEAST_CIRCLES;
    int i = many ? ahead.first(end) : due.next(0, end);
    while (i < due.size()) {
      circles.load(i);
      journal.save(circles.mover);
      double spent = fly(circles.mover, work, allowance, end);
      circles.store(i);
      if (spent <= end) {
        unfinished = true;
        end = spent;
      }
      i = many ? ahead.next(end) : due.next(i + 1, end);
    }
    return end;
  }

  /**
   * Resolves the mover's impacts until the given time.
   *
   * @return the time of the last one if the allowance was spent, else {@code +infinity}
   */
  private double fly(Mover m, ExactWork work, int allowance, double end) {
    long before = work.bits();
    int impacts = 0;
    double reached = 0;
    double due = m.due();
    do {
      if (m.next != Mover.NOTHING) {
        if (impacts > 0 && impacts + work.impactsSince(before) >= allowance) {
          return reached;
        }
        reached = due; // with a sensor no new flight begins
        if (response.resolve(m, log) && timeline != null) {
          timeline.note(m);
        }
        impacts++;
      }
      surroundings.extend(m, end - m.t);
      due = m.due();
    } while (due <= end);
    return Double.POSITIVE_INFINITY;
  }

  @Override
  void fly(Mover m) {
    if (m.id == circles.count) {
      circles.add();
    }
    surroundings.setRadius(m.id, m.radius);
    circles.store(m.id, m);
    if (timeline != null) {
      timeline.add(m);
    }
  }

  /** Only what happened to the circle itself is to be before. */
  @Override
  double tailOfEdit(Mover m, double now) {
    return m.t == now ? Math.max(0, m.tl) : 0;
  }

  @Override
  void remove(int i) {
    circles.due.set(i, Double.POSITIVE_INFINITY);
  }

  @Override
  void keep(int i, Mover m) {
    circles.store(i, m);
  }
}
