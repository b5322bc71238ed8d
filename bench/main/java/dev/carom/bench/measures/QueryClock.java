// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.methods.LineContender;
import dev.carom.bench.methods.LineDetector;
import dev.carom.oracle.SegmentQuery;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/**
 * Times the questions of each class in a virtual machine of its own, by one way to answer them. The
 * questions lie ready in an array; a pass asks each of them once, and the sum of the answers is
 * used, so that none is left out by the compiler. The classes take turns, as in a game all kinds of
 * questions come one after the other.
 */
final class QueryClock {

  static final int QUERIES = 2048;

  /** The form of a line of its output. */
  static final String LINE = "[a-z-]+ [0-9.E]+";

  private static final int NUMBERS = 10;
  private static final int PASSES = 15;

  /** Where answers go, for nobody to read. */
  @SuppressWarnings("UnusedVariable")
  private static volatile double sink;

  private final LineDetector detector;
  private final Map<String, double[]> queries = new LinkedHashMap<>();

  private QueryClock(LineDetector detector) {
    this.detector = detector;
    for (String name : Queries.classes()) {
      queries.put(name, flat(Queries.draw(name, QUERIES)));
    }
  }

  /**
   * Prints a line for each class: its name and the nanoseconds of a question.
   *
   * @param arguments the id of a {@link LineContender}, and the milliseconds of the warm-up
   */
  public static void main(String[] arguments) {
    QueryClock clock = new QueryClock(LineContender.byId(arguments[0]).detector());
    clock.warmUp(Long.parseLong(arguments[1]));
    clock.measure().forEach((name, nanos) -> System.out.println(name + " " + nanos));
  }

  private static double[] flat(List<SegmentQuery> list) {
    double[] flat = new double[list.size() * NUMBERS];
    for (int i = 0; i < list.size(); i++) {
      System.arraycopy(list.get(i).numbers(), 0, flat, i * NUMBERS, NUMBERS);
    }
    return flat;
  }

  private void warmUp(long millis) {
    long deadline = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
    do {
      queries.values().forEach(this::pass);
    } while (System.nanoTime() < deadline);
  }

  /** The median over the passes. */
  private Map<String, Double> measure() {
    Map<String, double[]> nanos = new LinkedHashMap<>();
    for (int pass = 0; pass < PASSES; pass++) {
      for (Map.Entry<String, double[]> entry : queries.entrySet()) {
        long start = System.nanoTime();
        pass(entry.getValue());
        double time = (System.nanoTime() - start) / (double) QUERIES;
        nanos.computeIfAbsent(entry.getKey(), none -> new double[PASSES])[pass] = time;
      }
    }
    Map<String, Double> medians = new LinkedHashMap<>();
    nanos.forEach((name, times) -> medians.put(name, new Quantiles(times).median()));
    return medians;
  }

  private void pass(double[] q) {
    double sum = 0;
    for (int i = 0; i < q.length; i += NUMBERS) {
      sum +=
          detector.time(
              q[i + 4], q[i + 5], q[i + 6], q[i + 7], q[i + 8], q[i], q[i + 1], q[i + 2], q[i + 3],
              q[i + 9]);
    }
    sink = sum;
  }
}
