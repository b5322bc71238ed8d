// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Scene;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Random;
import java.util.function.IntConsumer;

/** A world that runs for a given number of impacts, in rounds. */
public final class Soak {

  /** Rounds of a run. */
  public static final int ROUNDS = 20;

  /** The part of the rounds that is taken for the start, and for the end. */
  private static final int SHARE = 5;

  /** Rows of a step up to which each flight is checked. */
  private static final int MOST_ROWS = 20_000;

  /** For the processor's time, not the clock's: long runs have neighbours. */
  static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  /** A run that plays step by step and looks for what must not be. */
  interface Run {

    /** Plays one step, and returns how long it took of the processor, in nanoseconds. */
    long step() throws FindingException;

    /** Impacts so far. */
    long impacts();

    /** The world's time. */
    double now();

    /** Looks at the world at the end of a round. */
    default void endRound() {}
  }

  private Soak() {}

  /**
   * Runs an elastic scene of finite masses.
   *
   * @param impacts at least so many, after a twentieth of them that warms up and counts as well
   * @param afterRound told of each round that is done, from 1 to {@link #ROUNDS}
   */
  public static SoakResult run(Scene scene, long impacts, IntConsumer afterRound) {
    ElasticRun run = new ElasticRun(scene);
    try {
      SoakTimes times = run(run, impacts, afterRound);
      return run.result(times);
    } catch (FindingException e) {
      throw new AssertionError("an elastic run counts what it finds", e);
    }
  }

  /**
   * Runs a scene on which the end rule works, and checks each step as a fuzz does.
   *
   * @param impacts at least so many
   * @param afterRound told of each round that is done
   * @return how long it took
   * @throws FindingException if something is not as it must be
   */
  public static SoakTimes run(EndScene.Kind kind, long seed, long impacts, IntConsumer afterRound)
      throws FindingException {
    EndScene ends = new EndScene(kind, new Random(seed), 1, 1);
    StepWatch watch = new StepWatch(ends.scene(), 1, ends.trapped(), MOST_ROWS, seed);
    return run(
        new Run() {
          @Override
          public long step() throws FindingException {
            return watch.step(ends, false);
          }

          @Override
          public long impacts() {
            return watch.impacts();
          }

          @Override
          public double now() {
            return watch.world().now();
          }
        },
        impacts,
        afterRound);
  }

  private static SoakTimes run(Run run, long impacts, IntConsumer afterRound)
      throws FindingException {
    double[] nanosPerImpact = new double[ROUNDS];
    long heap = 0;
    for (int round = 0; round < ROUNDS; round++) {
      long before = run.impacts();
      long nanos = 0;
      while (run.impacts() < impacts * (round + 1) / ROUNDS) {
        nanos += run.step();
      }
      run.endRound();
      nanosPerImpact[round] = (double) nanos / Math.max(1, run.impacts() - before);
      heap = round == 0 ? heapInUse() : heap;
      afterRound.accept(round + 1);
    }
    return new SoakTimes(
        run.impacts(),
        run.now(),
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
