// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.jmh;

import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The canonical world: one frame of its steady state, and building it. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(2)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class WorldBenchmark {

  private Scene scene;
  private World world;

  /**
   * Generates the scene.
   *
   * @throws CannotPlaceException never, for the canonical scene
   */
  @Setup(Level.Trial)
  public void generate() throws CannotPlaceException {
    scene = Crosses.canonical(1).scene();
  }

  /** Starts from the beginning, so that no world grows old. */
  @Setup(Level.Iteration)
  public void start() {
    world = new World(scene);
  }

  /** One frame of trajectories that go on and on, unlike those of a replay. */
  @Benchmark
  public void frame() {
    world.step(1);
  }

  /** A world of the scene, ready for its first step. */
  @Benchmark
  public World build() {
    return new World(scene);
  }
}
