// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.jmh;

import dev.carom.SweptCircle;
import dev.carom.SweptSphere;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * One query of each kind: the time of impact of one circle of radius 10, aimed at a point of the
 * obstacle from about 100 px away, within one unit of time. A few thousand different queries take
 * turns, so that no branch is learnt by heart.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(2)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class QueryBenchmark {

  private static final int QUERIES = 4096;
  private static final int WIDTH = 6;
  private static final double RADIUS = 10;
  private static final double HALF_LINE = 50;

  /** Centre, velocity and the unit vector of a line, per query. The line's middle is the origin. */
  private final double[] aimed = new double[QUERIES * WIDTH];

  private int next;

  /** Draws the queries. */
  public QueryBenchmark() {
    SplittableRandom random = new SplittableRandom(1);
    for (int k = 0; k < aimed.length; k += WIDTH) {
      double from = random.nextDouble(2 * Math.PI);
      double distance = random.nextDouble(80, 120);
      double line = from + Math.PI / 2 + random.nextDouble(-1, 1);
      aimed[k] = distance * Math.cos(from);
      aimed[k + 1] = distance * Math.sin(from);
      aimed[k + 2] = -1.5 * aimed[k] + random.nextDouble(-5, 5);
      aimed[k + 3] = -1.5 * aimed[k + 1] + random.nextDouble(-5, 5);
      aimed[k + 4] = Math.cos(line);
      aimed[k + 5] = Math.sin(line);
    }
  }

  private int query() {
    next = next + 1 & QUERIES - 1;
    return next * WIDTH;
  }

  /**
   * Asks about a line that is shifted along itself, the origin at a given along from its middle.
   */
  private double line(int k, double sign, double middle) {
    double ux = aimed[k + 4];
    double uy = aimed[k + 5];
    double a = middle - HALF_LINE;
    double b = middle + HALF_LINE;
    return new SweptCircle(aimed[k], aimed[k + 1], RADIUS, sign * aimed[k + 2], sign * aimed[k + 3])
        .timeToLine(a * ux, a * uy, b * ux, b * uy, 1);
  }

  /** A circle that hits the inside of a line: the time of impact. */
  @Benchmark
  public double lineSide() {
    return line(query(), 1, 0);
  }

  /** A circle that is aimed at an end of a line: the time of impact. */
  @Benchmark
  public double lineEndpoint() {
    return line(query(), 1, HALF_LINE);
  }

  /** A circle that flies away from a line: infinity. */
  @Benchmark
  public double lineMiss() {
    return line(query(), -1, 0);
  }

  /**
   * A line abeam of the circle's way, along it, its nearest point at a distance from the centre.
   */
  private double beside(int k, double distance) {
    double vx = aimed[k + 2];
    double vy = aimed[k + 3];
    double part = distance / Math.hypot(vx, vy);
    double ax = aimed[k] + 0.4 * vx - part * vy;
    double ay = aimed[k + 1] + 0.4 * vy + part * vx;
    double bx = ax + HALF_LINE * aimed[k + 4];
    double by = ay + HALF_LINE * aimed[k + 5];
    boolean away = vx * (by - ay) - vy * (bx - ax) >= 0;
    return new SweptCircle(aimed[k], aimed[k + 1], RADIUS, vx, vy)
        .timeToLine(ax, ay, away ? bx : 2 * ax - bx, away ? by : 2 * ay - by, 1);
  }

  /** A circle that passes the end of a line by a hundredth of its radius: infinity. */
  @Benchmark
  public double lineNearMiss() {
    return beside(query(), 1.01 * RADIUS);
  }

  /**
   * A circle that grazes the end of a line, as nearly as doubles have it: some hit, some do not.
   *
   * @return the time of impact, or infinity
   */
  @Benchmark
  public double lineGraze() {
    return beside(query(), RADIUS);
  }

  /** A circle that flies away from a peg: infinity. */
  @Benchmark
  public double pegMiss() {
    int k = query();
    return new SweptCircle(aimed[k], aimed[k + 1], RADIUS, -aimed[k + 2], -aimed[k + 3])
        .timeToPeg(0, 0, RADIUS, 1);
  }

  /** Two moving circles that fly apart: infinity. */
  @Benchmark
  public double pairMiss() {
    int k = query();
    double vx = -aimed[k + 2] / 2;
    double vy = -aimed[k + 3] / 2;
    return new SweptCircle(aimed[k], aimed[k + 1], RADIUS, vx, vy)
        .timeToCircle(new SweptCircle(0, 0, RADIUS, -vx, -vy), 1);
  }

  /** A circle that is aimed at a peg: the time of impact. */
  @Benchmark
  public double peg() {
    int k = query();
    return new SweptCircle(aimed[k], aimed[k + 1], RADIUS, aimed[k + 2], aimed[k + 3])
        .timeToPeg(0, 0, RADIUS, 1);
  }

  /** A circle within bounds that flies away from their middle: the time of impact. */
  @Benchmark
  public double bounds() {
    int k = query();
    return new SweptCircle(aimed[k], aimed[k + 1], RADIUS, -aimed[k + 2], -aimed[k + 3])
        .timeToBounds(-130, -130, 130, 130, 1);
  }

  /** Two moving circles that are aimed at each other: the time of impact. */
  @Benchmark
  public double pair() {
    int k = query();
    double vx = aimed[k + 2] / 2;
    double vy = aimed[k + 3] / 2;
    return new SweptCircle(aimed[k], aimed[k + 1], RADIUS, vx, vy)
        .timeToCircle(new SweptCircle(0, 0, RADIUS, -vx, -vy), 1);
  }

  /**
   * Two moving spheres that are aimed at each other as the circles are, above one another by a
   * third of their radius.
   *
   * @return the time of impact
   */
  @Benchmark
  public double sphere() {
    int k = query();
    double vx = aimed[k + 2] / 2;
    double vy = aimed[k + 3] / 2;
    return new SweptSphere(aimed[k], aimed[k + 1], RADIUS / 3, RADIUS, vx, vy, 0)
        .timeToSphere(new SweptSphere(0, 0, 0, RADIUS, -vx, -vy, 0), 1);
  }
}
