// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Impact;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Snapshot;
import dev.carom.Timeline;
import dev.carom.World;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/**
 * Plays a step again: cut into several, with a snapshot that is restored on the way, and, where
 * circles ignore each other, of one circle alone. Rows and states must be the same, bit for bit.
 */
final class OtherWays {

  private static final int MOST_CUTS = 4;

  private final Random random;
  private final World sliced;
  private final World restored;
  private final World alone;

  OtherWays(Scene scene, long seed) {
    random = new Random(seed);
    sliced = new World(scene);
    restored = new World(scene);
    alone = new World(scene);
  }

  /**
   * Compares a step with its other ways.
   *
   * @param before the world before the step
   * @param timeline the recorded step
   */
  void check(Snapshot before, World world, Timeline timeline) throws FindingException {
    List<Impact> rows = rows(world);
    Snapshot after = world.snapshot();
    double[] cuts = cuts(before.now(), world.now(), rows);
    if (!sliced.snapshot().equals(before)) {
      sliced.restore(before);
    }
    List<Impact> seen = new ArrayList<>();
    int middle = random.nextInt(cuts.length);
    for (int k = 0; k < cuts.length; k++) {
      if (k == middle) {
        if (sliced.now() > before.now()) {
          same("recorded at " + sliced.now(), sliced.snapshot(), timeline.snapshot(sliced.now()));
        }
        restored.restore(sliced.snapshot());
        List<Impact> rest = play(restored, world.now());
        same(
            "restored at " + sliced.now(),
            rows.subList(Math.min(seen.size(), rows.size()), rows.size()),
            rest);
        same("restored at " + sliced.now(), after, restored.snapshot());
      }
      seen.addAll(play(sliced, cuts[k]));
    }
    same("cut at " + Arrays.toString(cuts), rows, seen);
    same("cut at " + Arrays.toString(cuts), after, sliced.snapshot());
    if (!world.scene().collide()) {
      int[] ids = world.ids(Kind.CIRCLE);
      checkAlone(ids[random.nextInt(ids.length)], before, world, rows);
    }
  }

  /** Ends of parts of a step, some at impacts; the last one is the step's. */
  private double[] cuts(double from, double to, List<Impact> rows) {
    double[] cuts = new double[1 + random.nextInt(MOST_CUTS)];
    for (int k = 0; k < cuts.length; k++) {
      cuts[k] =
          rows.isEmpty() || random.nextBoolean()
              ? Math.min(to, from + (to - from) * random.nextDouble())
              : rows.get(random.nextInt(rows.size())).time();
    }
    cuts[0] = to;
    Arrays.sort(cuts);
    return cuts;
  }

  private static List<Impact> play(World world, double end) {
    world.advanceTo(end);
    return rows(world);
  }

  static List<Impact> rows(World world) {
    List<Impact> rows = new ArrayList<>();
    world.impacts().forEach(rows::add);
    return rows;
  }

  void checkAlone(int i, Snapshot before, World world, List<Impact> rows) throws FindingException {
    alone.restore(before);
    for (int id : alone.ids(Kind.CIRCLE)) {
      if (id != i) {
        alone.remove(Kind.CIRCLE, id);
      }
    }
    String way = "circle " + i + " alone";
    same(way, rows.stream().filter(row -> row.circle() == i).toList(), play(alone, world.now()));
    same(way, state(world, i), state(alone, i));
  }

  private static List<Double> state(World world, int i) {
    return List.of(world.x(i), world.y(i), world.vx(i), world.vy(i));
  }

  private static void same(String way, Object expected, Object found) throws FindingException {
    if (!expected.equals(found)) {
      throw new FindingException("%s: %s, expected %s".formatted(way, found, expected));
    }
  }

  private static void same(String way, List<Impact> expected, List<Impact> found)
      throws FindingException {
    int k = 0;
    while (k < Math.min(expected.size(), found.size()) && expected.get(k).equals(found.get(k))) {
      k++;
    }
    if (k < Math.max(expected.size(), found.size())) {
      throw new FindingException(
          "%s: row %d of %d is %s, expected %s of %d"
              .formatted(
                  way,
                  k,
                  found.size(),
                  k < found.size() ? found.get(k) : "none",
                  k < expected.size() ? expected.get(k) : "none",
                  expected.size()));
    }
  }
}
