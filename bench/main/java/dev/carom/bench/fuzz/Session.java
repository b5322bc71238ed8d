// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.ObstacleKind;
import dev.carom.Outcome;
import dev.carom.Scene;
import dev.carom.Snapshot;
import dev.carom.Timeline;
import dev.carom.World;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;

/** One random world, stepped and edited at random, with everything checked after every step. */
final class Session {

  private static final int ACTIONS = 60;

  /** One of so many seeds in a row has many lines. */
  private static final int CROWDED = 4;

  /** Of one step: a corridor hardly wider than its circle would keep a session for hours. */
  private static final int MOST_IMPACTS = 2_000;

  private final Random random;
  private final Numbers numbers;
  private final Rounding rounding = new Rounding();
  private final SessionScene sessionScene;
  private final Scene scene;
  private World world;
  private EnergyCheck energy;
  private Edits edits;
  private boolean stuck;
  private long impacts;
  private long flights;
  private long steps;
  private long jams;

  Session(long seed) {
    boolean crowded = Math.floorMod(seed, CROWDED) == CROWDED - 1;
    random = new Random(seed);
    numbers = new Numbers(random);
    sessionScene = new SessionScene(random, numbers, crowded);
    scene = sessionScene.build();
    enter(new World(scene));
  }

  private void enter(World entered) {
    world = entered;
    energy = new EnergyCheck(world, numbers.speedUnit());
    edits = new Edits(random, numbers, sessionScene, world);
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

  Scene scene() {
    return scene;
  }

  void play() throws FindingException, IOException {
    for (int i = 0; i < ACTIONS && !stuck; i++) {
      int what = random.nextInt(20);
      if (what < 12) {
        step(numbers.duration());
      } else if (what < 19) {
        edits.edit();
      } else {
        reload();
      }
    }
  }

  private void step(double dt) throws FindingException {
    double start = world.now();
    Timeline timeline = world.record(MOST_IMPACTS);
    keepLimits();
    energy.begin();
    boolean complete = world.step(dt);
    ImpactLog log = world.impacts();
    steps++;
    impacts += log.size();
    LogCheck.check(world, start);
    readImpacts(log);
    stuck = !complete || log.size() >= MOST_IMPACTS;
    if (!stuck) {
      keepLimits();
      energy.end();
      checkFlights(start, timeline);
    }
  }

  private void readImpacts(ImpactLog log) {
    for (int row = 0; row < log.size(); row++) {
      jams += log.outcome(row) == Outcome.JAMMED ? 1 : 0;
      // Of what bounces to and fro at one time there are no flights.
      rounding.keepSpeed(log.approachSpeed(row), 0);
    }
  }

  private void checkFlights(double start, Timeline timeline) throws FindingException {
    var all = new StepFlights(world, timeline, start, rounding).all();
    for (var of : all) {
      flights += of.size();
      of.forEach(f -> rounding.keepSpeed(f.vx(), f.vy()));
    }
    new Crossings(world, rounding).check(all);
  }

  /** What there is now counts for the bound of rounding. */
  private void keepLimits() {
    scene.bounds().ifPresent(b -> rounding.keepPlace(b.xmin(), b.ymin(), b.xmax(), b.ymax()));
    for (int id : world.ids(ObstacleKind.CIRCLE)) {
      rounding.keepPlace(world.x(id), world.y(id), world.radius(id));
      rounding.keepSpeed(world.vx(id), world.vy(id));
    }
    for (int id : world.ids(ObstacleKind.LINE)) {
      var line = world.line(id);
      rounding.keepPlace(line.ax(), line.ay(), line.bx(), line.by());
    }
    for (int id : world.ids(ObstacleKind.PEG)) {
      var peg = world.peg(id);
      rounding.keepPlace(peg.x(), peg.y(), peg.radius());
    }
  }

  /** The session goes on in a new world, from what was written of the old one. */
  private void reload() throws FindingException, IOException {
    Snapshot snapshot = world.snapshot();
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    snapshot.write(out);
    World other = new World(scene);
    other.restore(Snapshot.read(new ByteArrayInputStream(out.toByteArray())));
    if (!other.snapshot().equals(snapshot)) {
      throw new FindingException("a snapshot that was written and read differs: " + snapshot);
    }
    enter(other);
  }
}
