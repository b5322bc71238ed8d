// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Outcome;
import dev.carom.Scene;
import dev.carom.Snapshot;
import dev.carom.Timeline;
import dev.carom.UnfinishedException;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.Sides;
import java.util.Set;

/** Steps a world and checks each step by all rules, without the library's detector. */
final class StepWatch {

  /** A circle crosses its own size in no less than so much of the clock: see {@link World}. */
  private static final double CLOCK = 0x1p-90;

  /** One of so many steps is played in other ways. */
  private static final int EACH = 4;

  /** Flights of a step with more rows are not checked. */
  private final int mostRows;

  private final Scene scene;
  private final double speedUnit;
  private final Motions motions;
  private final Rounding rounding = new Rounding();
  private final MassCheck masses = new MassCheck();
  private final PassedOver passed = new PassedOver();
  private final PlaceCheck places = new PlaceCheck();
  private final DeepHits deep = new DeepHits();
  private final JamCheck jam;
  private final OtherWays ways;
  private World world;
  private EnergyCheck energy;
  private boolean complete = true;
  private long impacts;
  private long flights;
  private long steps;
  private long jams;

  /**
   * Watches a world of its own.
   *
   * @param trapped circles that cannot leave their places
   * @param motions those of obstacles; null where obstacles rest
   * @param mostRows of a step with more rows the flights are not checked
   */
  StepWatch(
      Scene scene,
      double speedUnit,
      Set<Integer> trapped,
      Motions motions,
      int mostRows,
      long seed) {
    this.scene = scene;
    this.motions = motions;
    this.speedUnit = speedUnit;
    this.mostRows = mostRows;
    jam = new JamCheck(trapped, speedUnit);
    ways = new OtherWays(scene, seed);
    enter(new World(scene));
  }

  /** Goes on in another world of the same state. */
  void enter(World entered) {
    world = entered;
    energy = energy == null ? new EnergyCheck(world, speedUnit) : energy.of(world);
    places.enter(world);
    masses.enter(world);
    passed.enter(world);
  }

  World world() {
    return world;
  }

  /** Notes that the world was edited. */
  void edited() {
    jam.edited();
  }

  /** Whether the last step led to its end. */
  boolean isComplete() {
    return complete;
  }

  /** Impacts of the last step. */
  int rows() {
    return world.impacts().size();
  }

  long impacts() {
    return impacts;
  }

  long flights() {
    return flights;
  }

  long steps() {
    return steps;
  }

  long jams() {
    return jams;
  }

  /**
   * Steers a scene and plays a step of it.
   *
   * @param edited whether other edits may keep a step from its end
   */
  long step(EndScene ends, boolean edited) throws FindingException {
    if (ends.steer(world)) {
      jam.edited();
    }
    long nanos = step(ends.duration());
    if (!edited && ends.finishes()) {
      demandEnd();
    }
    return nanos;
  }

  /** Demands that the last step led to its end. */
  void demandEnd() throws FindingException {
    if (!complete) {
      throw new FindingException("a step did not end, at " + world.now());
    }
  }

  /** Plays a step, and returns how long it took of the processor, in nanoseconds. */
  long step(double dt) throws FindingException {
    Snapshot before = world.snapshot();
    double start = world.now();
    Timeline timeline = world.record(Double.POSITIVE_INFINITY);
    keepLimits();
    energy.begin();
    places.begin();
    long begin = Soak.THREADS.getCurrentThreadCpuTime();
    complete = isFinished(dt);
    long nanos = Soak.THREADS.getCurrentThreadCpuTime() - begin;
    ImpactLog log = world.impacts();
    steps++;
    impacts += log.size();
    LogCheck.check(world, start);
    places.end(haveTurned());
    masses.read(log);
    passed.read(log);
    readImpacts(log);
    if (complete && log.size() < mostRows) {
      keepLimits();
      if (!haveTurned()) {
        energy.end();
        jam.check(world, timeline, dt > 0);
      }
      deep.read(world, timeline);
      checkFlights(start, timeline);
      if (isWithinClock() && steps % EACH == 0) {
        ways.check(before, world, timeline);
      }
    } else {
      deep.assumeOf(world);
    }
    masses.end();
    passed.end();
    return nanos;
  }

  private boolean haveTurned() {
    return motions != null && motions.haveTurned();
  }

  private boolean isFinished(double dt) {
    try {
      world.step(dt);
      return true;
    } catch (UnfinishedException e) {
      return false;
    }
  }

  /** Whether nobody is so fast that the order of impacts may depend on a restored snapshot. */
  private boolean isWithinClock() {
    double least = Double.POSITIVE_INFINITY;
    for (int id : world.ids(Kind.CIRCLE)) {
      least = Math.min(least, world.radius(id));
    }
    return rounding.fastest() * world.now() * CLOCK < least;
  }

  private void readImpacts(ImpactLog log) {
    for (int row = 0; row < log.size(); row++) {
      jams += log.outcome(row) == Outcome.JAMMED ? 1 : 0;
      // There are no flights of circles that bounce to and fro at one time.
      rounding.keepSpeed(log.approachSpeed(row), 0);
    }
  }

  private void checkFlights(double start, Timeline timeline) throws FindingException {
    var all = new StepFlights(world, timeline, start, rounding, deep, haveTurned()).all();
    for (var of : all) {
      flights += of.size();
      of.forEach(f -> rounding.keepSpeed(f.vx(), f.vy()));
    }
    masses.check(all);
    Set<String> turning = motions == null ? Set.of() : motions.turning(start);
    if (!world.gravity().equals(Vec2.ZERO) && turning.isEmpty()) {
      new SupportCheck(world, rounding, passed).check(all);
    }
    new Crossings(world, rounding, masses, passed, turning).check(all);
    new TurnCheck(world, rounding, passed, turning, timeline).check(all);
  }

  /** Everything there is now counts for the bound of rounding. */
  private void keepLimits() {
    scene.bounds().ifPresent(b -> rounding.keepPlace(b.xmin(), b.ymin(), b.xmax(), b.ymax()));
    for (int id : world.ids(Kind.CIRCLE)) {
      rounding.keepPlace(world.x(id), world.y(id), world.radius(id));
      rounding.keepSpeed(world.vx(id), world.vy(id));
    }
    for (int id : world.ids(Kind.LINE)) {
      for (Line side : Sides.of(world.shape(Kind.LINE, id))) {
        rounding.keepPlace(side.ax(), side.ay(), side.bx(), side.by());
      }
      keepSpeed(world.velocity(Kind.LINE, id));
    }
    for (int id : world.ids(Kind.PEG)) {
      var peg = world.peg(id);
      rounding.keepPlace(peg.x(), peg.y(), peg.radius());
      keepSpeed(world.velocity(Kind.PEG, id));
    }
  }

  private void keepSpeed(Vec2 velocity) {
    rounding.keepSpeed(velocity.x(), velocity.y());
  }
}
