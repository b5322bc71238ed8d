// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Scene;
import dev.carom.Snapshot;
import dev.carom.World;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;
import java.util.Set;

/**
 * One random world, stepped and edited at random, with everything checked after every step. Each
 * fourth seed has a scene on which the end rule works, without random edits as a rule: only then
 * what the scene promises holds. In one third of the others some lines and pegs move, and one third
 * of them have gravity.
 */
final class Session {

  private static final int ACTIONS = 60;

  /** One of so many seeds in a row has many lines. */
  private static final int CROWDED = 4;

  /** One of so many seeds in a row has a scene on which the end rule works. */
  private static final int ENDS = 4;

  /** One of so many seeds in a row has obstacles that move, unless the end rule works there. */
  private static final int MOVING = 3;

  /** One of so many seeds in a row has outlines, unless the end rule works there. */
  private static final int JOINED = 13;

  /** Of one step: a corridor hardly wider than its circle would keep a session for hours. */
  private static final int MOST_IMPACTS = 2_000;

  /** Of one step of trapped circles. */
  private static final int MOST_OF_TRAPPED = 10_000;

  /** Impacts of a part of a step, if they come as fast as in the last one. */
  private static final double PART = 500;

  private final Random random;
  private final Numbers numbers;
  private final SessionScene draws;
  private final Filters filters;
  private final Falls falls;
  private final Variation variation;

  /** Null for an ordinary scene. */
  private final EndScene ends;

  /** Null where obstacles rest. */
  private final Motions motions;

  private final boolean edited;
  private final Scene scene;
  private final StepWatch watch;
  private Edits edits;
  private boolean stuck;

  /** In which that many impacts are expected; as long as there are none, no limit. */
  private double time = Double.POSITIVE_INFINITY;

  Session(long seed) {
    boolean crowded = Math.floorMod(seed, CROWDED) == CROWDED - 1;
    random = new Random(seed);
    boolean ordinary = Math.floorMod(seed, ENDS) > 0;
    Variation.Kind kind = ordinary ? Variation.Kind.of(seed) : Variation.Kind.NONE;
    numbers = new Numbers(random, kind == Variation.Kind.SMALL);
    variation = new Variation(kind, seed, numbers.length());
    filters = new Filters(~seed);
    boolean moves = ordinary && Math.floorMod(seed, MOVING) == MOVING - 1;
    motions = moves ? new Motions(seed, numbers) : null;
    falls = new Falls(seed, numbers);
    int outlines = Math.floorMod(seed, JOINED) == 4 ? 1 + Math.floorMod(seed, 3) : 0;
    draws =
        new SessionScene(random, numbers, filters, falls, variation, crowded, motions, outlines);
    edited = ordinary || random.nextInt(3) == 0;
    ends = ordinary ? null : endScene(Math.floorDiv(seed, ENDS));
    scene = ordinary ? draws.build() : ends.scene();
    Set<Integer> trapped = edited ? Set.of() : ends.trapped();
    int most = ordinary ? MOST_IMPACTS : MOST_OF_TRAPPED;
    watch = new StepWatch(scene, numbers.speedUnit(), trapped, motions, most, seed);
    enter(watch.world());
  }

  private EndScene endScene(long number) {
    EndScene.Layout[] kinds = EndScene.Layout.values();
    EndScene.Layout kind = kinds[(int) Math.floorMod(number, (long) kinds.length)];
    return new EndScene(kind, random, numbers.length(), numbers.speedUnit());
  }

  private void enter(World world) {
    watch.enter(world);
    edits = new Edits(random, numbers, variation, draws, world);
  }

  StepWatch watch() {
    return watch;
  }

  Scene scene() {
    return scene;
  }

  void play() throws FindingException, IOException {
    for (int i = 0; i < ACTIONS && !stuck; i++) {
      if (motions != null && motions.edit(watch.world())) {
        watch.edited();
      }
      if (ends == null && falls.edit(watch.world())) {
        watch.edited();
      }
      int what = random.nextInt(20);
      if (what == 19) {
        reload();
      } else if (edited && what >= (ends == null ? 12 : 17)) {
        edit();
      } else if (ends == null) {
        if (variation.editsEachStep()) {
          edit();
        }
        step(numbers.duration());
      } else {
        stepOfEnds();
      }
    }
  }

  private void edit() throws FindingException {
    edits.edit();
    filters.edit(watch.world());
    watch.edited();
  }

  private void stepOfEnds() throws FindingException {
    watch.step(ends, edited);
    if (!watch.isComplete()) {
      watch.step(0);
      stuck = true;
    }
  }

  /** In parts, if the last one tells of so many impacts. */
  private void step(double dt) throws FindingException {
    World world = watch.world();
    double end = world.now() + dt;
    do {
      double start = world.now();
      double part = Math.max(time, 2 * Math.ulp(start));
      watch.step(untilArrival(start, start + part < end ? part : end - start));
      stuck = !watch.isComplete() || watch.rows() >= MOST_IMPACTS;
      double passed = world.now() - start;
      time = passed == 0 ? time : PART * passed / watch.rows();
    } while (!stuck && world.now() < end);
  }

  /**
   * The part of a step of some length before the next arrival of an obstacle; if there is none, up
   * to the arrival. So each obstacle has one velocity in each step, as the checks assume.
   */
  private double untilArrival(double start, double dt) {
    double arrival = motions == null ? Double.POSITIVE_INFINITY : motions.nextArrival(start);
    double part = dt;
    while (start + part >= arrival) {
      part = Math.min(Math.nextDown(arrival) - start, Math.nextDown(part));
    }
    return start + part > start || dt == 0 ? part : arrival - start;
  }

  /** The session goes on in a new world, from what was written of the old one. */
  private void reload() throws FindingException, IOException {
    Snapshot snapshot = watch.world().snapshot();
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
