// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.jmh;

import dev.carom.Casts;
import dev.carom.Circle;
import dev.carom.Impact;
import dev.carom.Kind;
import dev.carom.Nearest;
import dev.carom.Resolver;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SweptCircle;
import dev.carom.Trajectory;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Questions among lines of length 20, 5 on each 1,000 square units, and among circles. The places
 * and directions are random; a few thousand of them take turns.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(2)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class QuestionBenchmark {

  private static final int QUESTIONS = 4096;
  private static final int IMPACTS = 20;
  private static final int RAYS = 10_000;
  private static final double FAR = 1e9;

  /** Places, directions, and which comes next. */
  private static class Questions {

    final Circle[] points = new Circle[QUESTIONS];
    final Circle[] disks = new Circle[QUESTIONS];
    final Vec2[] velocities = new Vec2[QUESTIONS];
    private int next;

    void draw(SplittableRandom random, double side) {
      for (int i = 0; i < QUESTIONS; i++) {
        double x = side * random.nextDouble();
        double y = side * random.nextDouble();
        double angle = random.nextDouble(2 * Math.PI);
        points[i] = new Circle(x, y, 0);
        disks[i] = new Circle(x, y, 10);
        velocities[i] = new Vec2(Math.cos(angle), Math.sin(angle));
      }
    }

    int next() {
      next = next + 1 & QUESTIONS - 1;
      return next;
    }
  }

  /** Lines in a square. */
  @State(Scope.Thread)
  public static class Lines extends Questions {

    /** How many lines. */
    @Param({"100", "5000", "100000"})
    public int lines = 5000;

    World world;
    Resolver resolver;
    final Casts rays = new Casts();

    /** Draws the lines and the questions. */
    @Setup
    public void draw() {
      SplittableRandom random = new SplittableRandom(1);
      double side = Math.sqrt(200.0 * lines);
      SceneBuilder scene = Scene.builder().bounds(0, 0, side, side);
      for (int i = 0; i < lines; i++) {
        double x = side * random.nextDouble();
        double y = side * random.nextDouble();
        double angle = random.nextDouble(2 * Math.PI);
        scene.line(x, y, x + 20 * Math.cos(angle), y + 20 * Math.sin(angle));
      }
      world = new World(scene.build());
      resolver = world.scene().resolver();
      draw(random, side);
      for (int i = 0; i < RAYS; i++) {
        double angle = i * (2 * Math.PI / RAYS);
        rays.add(side / 2, side / 2, 0, Math.cos(angle), Math.sin(angle));
      }
    }
  }

  /** 10,000 circles that collide, in a square of 1,000. */
  @State(Scope.Thread)
  public static class Circles extends Questions {

    World world;

    /** Draws the circles and the questions. */
    @Setup
    public void draw() {
      draw(0);
    }

    void draw(double gravity) {
      SplittableRandom random = new SplittableRandom(1);
      SceneBuilder scene = Scene.builder().bounds(0, 0, 1000, 1000).gravity(0, gravity);
      for (int i = 0; i < 10_000; i++) {
        double vx = random.nextDouble(-1, 1);
        double vy = random.nextDouble(-1, 1);
        scene.circle(5 + 10 * (i % 100), 5 + 10 * (i / 100), 3, vx, vy);
      }
      world = new World(scene.build());
      world.advanceTo(5);
      draw(random, 1000);
    }
  }

  /** The same circles, which fall. */
  @State(Scope.Thread)
  public static class Falling extends Circles {

    @Override
    @Setup
    public void draw() {
      draw(-1);
    }
  }

  /** The first impact of a ray in a world. */
  @Benchmark
  public Optional<Impact> cast(Lines lines) {
    int i = lines.next();
    return lines.world.cast(new SweptCircle(lines.points[i], lines.velocities[i]), FAR);
  }

  /** The first impact of a ray, without a world. */
  @Benchmark
  public Optional<Impact> castOfResolver(Lines lines) {
    int i = lines.next();
    return lines.resolver.cast(new SweptCircle(lines.points[i], lines.velocities[i]), FAR);
  }

  /** One of 10,000 rays of a lidar, asked in one call: the last distance. */
  @Benchmark
  @OperationsPerInvocation(RAYS)
  public double lidar(Lines lines) {
    lines.world.cast(lines.rays, FAR);
    return lines.rays.time(RAYS - 1);
  }

  /** One of twenty bounces of a path. */
  @Benchmark
  @OperationsPerInvocation(IMPACTS)
  public Trajectory trace(Lines lines) {
    int i = lines.next();
    return lines.world.trace(
        new SweptCircle(lines.points[i], lines.velocities[i]), 1, FAR, IMPACTS);
  }

  /** The line that is nearest to a point: its id. */
  @Benchmark
  public int nearest(Lines lines) {
    Circle point = lines.points[lines.next()];
    return lines.world.nearest(point.x(), point.y(), Kind.LINE).map(Nearest::id).orElse(-1);
  }

  /** The nearest obstacle, without a world. */
  @Benchmark
  public Optional<Nearest> nearestOfResolver(Lines lines) {
    Circle point = lines.points[lines.next()];
    return lines.resolver.nearest(point.x(), point.y());
  }

  /** The three or four lines that overlap a disk of radius 10: their ids. */
  @Benchmark
  public int[] overlapping(Lines lines) {
    return lines.world.overlapping(Kind.LINE, lines.disks[lines.next()]);
  }

  /** The first impact of a ray among circles that collide, at their speed. */
  @Benchmark
  public Optional<Impact> castAmongCircles(Circles circles) {
    int i = circles.next();
    return circles.world.cast(new SweptCircle(circles.points[i], circles.velocities[i]), FAR);
  }

  /** The same among circles that fall and collide. */
  @Benchmark
  public Optional<Impact> castAmongFalling(Falling circles) {
    return castAmongCircles(circles);
  }
}
