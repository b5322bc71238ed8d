// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Scene;
import dev.carom.World;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.function.IntConsumer;

/** A world that runs for a given number of impacts, in rounds; elastic and with finite masses. */
public final class Soak {

  /** Rounds of a run. */
  public static final int ROUNDS = 20;

  /** The part of the rounds that is taken for the start, and for the end. */
  private static final int SHARE = 5;

  /** Steps are so long that one has some hundred impacts. */
  private static final double IMPACTS_PER_STEP = 400;

  private static final int FRAMES_OF_TRIAL = 100;

  /** For the processor's time, not the clock's: long runs have neighbours. */
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  private final Scene scene;
  private final World world;
  private final Guard guard;
  private final double[] energies;
  private final double step;
  private long impacts;
  private long nanos;
  private long escapes;
  private long overlaps;

  private Soak(Scene scene) {
    this.scene = scene;
    world = new World(scene);
    guard = new Guard(scene, world);
    energies = energies();
    step = stepLength();
  }

  /** A whole number of frames, found from the impacts of the first ones. */
  private double stepLength() {
    long found = 0;
    World trial = new World(scene);
    for (int frame = 1; frame <= FRAMES_OF_TRIAL; frame++) {
      while (!trial.advanceTo(frame)) {
        found += trial.impacts().size();
      }
      found += trial.impacts().size();
    }
    if (found == 0) {
      throw new IllegalArgumentException(
          "no impact in " + FRAMES_OF_TRIAL + " frames: expected a scene with impacts");
    }
    return Math.max(1, Math.rint(IMPACTS_PER_STEP * FRAMES_OF_TRIAL / found));
  }

  /**
   * Runs a scene.
   *
   * @param scene the scene, elastic
   * @param impacts at least so many, after a twentieth of them that warms up and counts as well
   * @param afterRound told of each round that is done, from 1 to {@link #ROUNDS}
   * @return what was found
   */
  public static SoakResult run(Scene scene, long impacts, IntConsumer afterRound) {
    Soak soak = new Soak(scene);
    double[] nanosPerImpact = new double[ROUNDS];
    long heap = 0;
    for (int round = 0; round < ROUNDS; round++) {
      long before = soak.impacts;
      soak.nanos = 0;
      soak.play(impacts * (round + 1) / ROUNDS);
      nanosPerImpact[round] = (double) soak.nanos / (soak.impacts - before);
      heap = round == 0 ? heapInUse() : heap;
      afterRound.accept(round + 1);
    }
    return soak.result(nanosPerImpact, heap);
  }

  private void play(long until) {
    while (impacts < until) {
      double end = Math.floor(world.now() / step) * step + step;
      boolean complete;
      do {
        long start = THREADS.getCurrentThreadCpuTime();
        complete = world.advanceTo(end);
        nanos += THREADS.getCurrentThreadCpuTime() - start;
        impacts += world.impacts().size();
        guard.watch(world.impacts());
      } while (!complete);
    }
    escapes = Math.max(escapes, guard.outside());
    overlaps = Math.max(overlaps, guard.overlaps());
  }

  private SoakResult result(double[] nanosPerImpact, long heap) {
    return new SoakResult(
        impacts,
        world.now(),
        escapes,
        guard.crossings(),
        overlaps,
        drift(),
        heap,
        heapInUse(),
        median(nanosPerImpact, 1, 1 + ROUNDS / SHARE),
        median(nanosPerImpact, ROUNDS - ROUNDS / SHARE, ROUNDS),
        Arrays.stream(nanosPerImpact).skip(1).min().getAsDouble(),
        Arrays.stream(nanosPerImpact).skip(1).max().getAsDouble());
  }

  /** What can be reached now. */
  private static long heapInUse() {
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    return runtime.totalMemory() - runtime.freeMemory();
  }

  private static double median(double[] values, int from, int to) {
    double[] sorted = Arrays.copyOfRange(values, from, to);
    Arrays.sort(sorted);
    int half = sorted.length / 2;
    return (sorted[half] + sorted[sorted.length - 1 - half]) / 2;
  }

  private double[] energies() {
    double[] now = new double[world.circleCount()];
    for (int i = 0; i < now.length; i++) {
      now[i] = world.mass(i) / 2 * (world.vx(i) * world.vx(i) + world.vy(i) * world.vy(i));
    }
    return now;
  }

  /** Of all circles together if they collide; else of the worst one. */
  private double drift() {
    double[] now = energies();
    if (scene.collide()) {
      return Arrays.stream(now).sum() / Arrays.stream(energies).sum() - 1;
    }
    double worst = 0;
    for (int i = 0; i < now.length; i++) {
      double change = energies[i] == 0 ? now[i] : now[i] / energies[i] - 1;
      worst = Math.abs(change) > Math.abs(worst) ? change : worst;
    }
    return worst;
  }
}
