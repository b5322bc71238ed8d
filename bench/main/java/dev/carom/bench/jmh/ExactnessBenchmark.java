// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.jmh;

import dev.carom.SweptCircle;
import dev.carom.bench.methods.PlainSweptCircle;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.SegmentQuery;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The cost of exactness: one query, answered by the library and by the same decisions in plain
 * doubles. Different queries of one family take turns. Their number matters: a processor learns the
 * branches of some thousand queries by heart, which it cannot in a game.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(2)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class ExactnessBenchmark {

  private static final int WIDTH = 11;

  /** The kind of queries: ordinary ones, those near a graze, and those that start touching. */
  @Param({
    "seg_uniform",
    "circ_uniform",
    "seg_near_graze",
    "circ_near_graze",
    "seg_start_touching",
    "circ_touching"
  })
  public String family;

  /** How many different queries, a power of two. */
  @Param({"4096", "65536"})
  public int queries = 65_536;

  private double[] numbers;
  private boolean lines;
  private int next;

  /** Draws the queries. */
  @Setup
  public void draw() {
    Family drawn =
        Families.all().stream().filter(f -> f.name().equals(family)).findFirst().orElseThrow();
    Draw draw = new Draw(1);
    numbers = new double[queries * WIDTH];
    lines = drawn.next(draw) instanceof SegmentQuery;
    for (int k = 0; k < numbers.length; k += WIDTH) {
      double[] n = drawn.next(draw).numbers();
      System.arraycopy(n, 0, numbers, k, n.length);
    }
  }

  private int query() {
    next = next + 1 & queries - 1;
    return next * WIDTH;
  }

  /** Plain doubles: the time of impact. */
  @Benchmark
  public double plain() {
    double[] n = numbers;
    int k = query();
    return lines
        ? PlainSweptCircle.line(
            n[k + 4], n[k + 5], n[k + 6], n[k + 7], n[k + 8], n[k], n[k + 1], n[k + 2], n[k + 3],
            n[k + 9])
        : PlainSweptCircle.pair(
            n[k], n[k + 1], n[k + 2], n[k + 3], n[k + 4], n[k + 5], n[k + 6], n[k + 7], n[k + 8],
            n[k + 9], n[k + 10]);
  }

  /** This library: the time of impact. */
  @Benchmark
  public double exact() {
    double[] n = numbers;
    int k = query();
    return lines
        ? SweptCircle.line(
            n[k + 4], n[k + 5], n[k + 6], n[k + 7], n[k + 8], n[k], n[k + 1], n[k + 2], n[k + 3],
            n[k + 9])
        : SweptCircle.pair(
            n[k], n[k + 1], n[k + 2], n[k + 3], n[k + 4], n[k + 5], n[k + 6], n[k + 7], n[k + 8],
            n[k + 9], n[k + 10]);
  }
}
