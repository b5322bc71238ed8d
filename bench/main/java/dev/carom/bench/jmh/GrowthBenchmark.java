// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.jmh;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.experiment.Tiles;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Circles that ignore each other, from one to a million, among lines as dense as in the canonical
 * scene: a frame, building the world, and reading all positions. Up to 100 circles share the lines
 * of that scene; from there on there are as many lines as circles.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(2)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class GrowthBenchmark {

  /** A hundred of them fill a canonical scene. */
  private static final int TILE = 100;

  /** How many; above 100, the next lower hundred times a square is taken. */
  @Param({"1", "10", "100", "1000", "10000", "100000", "1000000"})
  public int circles = TILE;

  private Scene scene;
  private World world;

  /**
   * Generates the scene.
   *
   * @throws CannotPlaceException never, for these scenes
   */
  @Setup(Level.Trial)
  public void generate() throws CannotPlaceException {
    scene =
        circles <= TILE
            ? new Crosses(circles, 50, 10, 1, 10, 1).scene()
            : new Tiles((int) Math.sqrt((double) circles / TILE), true, 1).scene();
  }

  /** Starts from the beginning, so that no world grows old. */
  @Setup(Level.Iteration)
  public void start() {
    world = new World(scene);
    world.step(1);
  }

  /** One frame. */
  @Benchmark
  public void frame() {
    world.step(1);
  }

  /** A world of the scene, ready for its first step. */
  @Benchmark
  public World build() {
    return new World(scene);
  }

  /** All positions, read one by one: their sum. */
  @Benchmark
  public double positions() {
    double sum = 0;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      sum += world.x(i) + world.y(i);
    }
    return sum;
  }
}
