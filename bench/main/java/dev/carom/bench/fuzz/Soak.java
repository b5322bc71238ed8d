// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Scene;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Random;
import java.util.Set;
import java.util.function.IntConsumer;

/** A world that runs for a given number of impacts, in rounds; each step is checked. */
public final class Soak {

  /** Rounds of a run. */
  public static final int ROUNDS = 20;

  /** The part of the rounds that is taken for the start, and for the end. */
  private static final int SHARE = 5;

  /** Rows of a step up to which each flight is checked. */
  private static final int MOST_ROWS = 20_000;

  /** The length of a step of a scene that nobody steers, in frames. */
  private static final double STEP = 10;

  /** For the processor's time, not the clock's: long runs have neighbours. */
  static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  /** Plays one step, and returns how long it took of the processor, in nanoseconds. */
  private interface Step {
    long play(StepWatch watch) throws FindingException;
  }

  private Soak() {}

  /**
   * Runs a scene that nobody steers.
   *
   * @param impacts at least so many
   * @param afterRound told of each round that is done, from 1 to {@link #ROUNDS}
   * @throws FindingException if something is not as it must be, or nothing is hit in a step
   */
  public static SoakTimes run(Scene scene, long impacts, IntConsumer afterRound)
      throws FindingException {
    StepWatch watch = new StepWatch(scene, 1, Set.of(), null, MOST_ROWS, 1);
    return run(watch, Soak::stepOn, impacts, afterRound);
  }

  private static long stepOn(StepWatch watch) throws FindingException {
    long nanos = watch.step(STEP);
    watch.demandEnd();
    if (watch.rows() == 0) {
      throw new FindingException("no impact in a step: expected a scene with impacts");
    }
    return nanos;
  }

  /**
   * Runs a scene on which the end rule works.
   *
   * @param impacts at least so many
   * @param afterRound told of each round that is done
   * @throws FindingException if something is not as it must be
   */
  public static SoakTimes run(EndScene.Layout kind, long seed, long impacts, IntConsumer afterRound)
      throws FindingException {
    EndScene ends = new EndScene(kind, new Random(seed), 1, 1);
    StepWatch watch = new StepWatch(ends.scene(), 1, ends.trapped(), null, MOST_ROWS, seed);
    return run(watch, each -> each.step(ends, false), impacts, afterRound);
  }

  private static SoakTimes run(StepWatch watch, Step step, long impacts, IntConsumer afterRound)
      throws FindingException {
    double[] nanosPerImpact = new double[ROUNDS];
    long heap = 0;
    for (int round = 0; round < ROUNDS; round++) {
      long before = watch.impacts();
      long nanos = 0;
      while (watch.impacts() < impacts * (round + 1) / ROUNDS) {
        nanos += step.play(watch);
      }
      nanosPerImpact[round] = (double) nanos / Math.max(1, watch.impacts() - before);
      heap = round == 0 ? heapInUse() : heap;
      afterRound.accept(round + 1);
    }
    return new SoakTimes(
        watch.impacts(),
        watch.world().now(),
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
}
