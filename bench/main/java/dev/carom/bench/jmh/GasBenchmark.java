// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.jmh;

import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Gas;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.AuxCounters;
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
 * A gas of circles that collide, from a hundred to a million at equal density: frames and events
 * (impacts with walls and each other) per second, and building the world.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Fork(2)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class GasBenchmark {

  private static final double PACKING = 0.2;

  /** In which a circle flies a tenth of its radius or so. */
  private static final double FRAME = 0.1;

  /** How many. */
  @Param({"100", "1000", "10000", "100000", "1000000"})
  public int circles = 1000;

  private Scene scene;
  private World world;

  /** Events in the frames; JMH reports them per second. */
  @State(Scope.Thread)
  @AuxCounters(AuxCounters.Type.OPERATIONS)
  public static class Count {

    /** Impacts. */
    public long events;
  }

  /**
   * Generates the scene.
   *
   * @throws CannotPlaceException never, for these scenes
   */
  @Setup(Level.Trial)
  public void generate() throws CannotPlaceException {
    scene = new Gas(circles, PACKING, 1, false, 1).scene();
  }

  /** Starts from the beginning, so that no world grows old. */
  @Setup(Level.Iteration)
  public void start() {
    world = new World(scene);
    world.step(FRAME);
  }

  /**
   * One frame.
   *
   * @param count takes its impacts
   */
  @Benchmark
  public void frame(Count count) {
    world.step(FRAME);
    count.events += world.impacts().size();
  }

  /** A world of the scene, ready for its first step. */
  @Benchmark
  public World build() {
    return new World(scene);
  }
}
