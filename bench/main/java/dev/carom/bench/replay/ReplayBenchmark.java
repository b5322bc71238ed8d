// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.peers.Contenders;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.openjdk.jmh.infra.IterationParams;
import org.openjdk.jmh.runner.IterationType;

/**
 * One replay of a scene from its start, each frame stamped. The world is built outside of what is
 * timed. Between two measured replays another scene is played, since a processor that sees the same
 * frames again and again learns their branches by heart and is faster than any game will be.
 *
 * <p>A fork that is handed a folder reads its scenes there and leaves its {@link Samples} there;
 * without one the canonical scene of seed 1 is played and JMH's own figure is all there is.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 1)
@Measurement(iterations = ReplayBenchmark.REPLAYS)
public class ReplayBenchmark {

  /** Measured replays of one fork. */
  static final int REPLAYS = 20;

  static final String NO_FOLDER = "none";

  /** The id of one of the {@link Contenders}. */
  @Param({"carom", "poster"})
  public String method;

  /** The frames of one replay. */
  @Param("600")
  public int frames;

  /** How long to play before the first measured replay. */
  @Param("2000")
  public int warmUpMillis;

  /** Where scenes are read and samples written. */
  @Param(NO_FOLDER)
  public String folder;

  /** The number of this fork, which names its samples. */
  @Param("0")
  public int fork;

  private Contender contender;
  private Scene scene;
  private List<Scene> others;
  private int othersPlayed;
  private Method playing;
  private long[] nanos;
  private long[] cold;
  private final List<long[]> replays = new ArrayList<>();

  /**
   * Reads or makes the scenes.
   *
   * @throws IOException if a scene cannot be read
   * @throws CannotPlaceException never, for the canonical scene
   */
  @Setup(Level.Trial)
  public void load() throws IOException, CannotPlaceException {
    contender = Contenders.byId(method);
    if (folder.equals(NO_FOLDER)) {
      scene = Crosses.canonical(1).scene();
      others = List.of(Crosses.canonical(2).scene());
    } else {
      scene = exchange().readMeasured();
      others = exchange().readOthers();
    }
  }

  /** Warms up, if that is what this iteration is for; then sets a fresh world in motion. */
  @Setup(Level.Iteration)
  public void prepare(IterationParams iteration) {
    if (iteration.getType() == IterationType.WARMUP) {
      warmUp();
    }
    playOther();
    playing = contender.start(scene);
    nanos = new long[frames];
  }

  /** The first replay of the fork is kept: it is the cold start. */
  private void warmUp() {
    long deadline = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(warmUpMillis);
    cold = play(scene);
    while (System.nanoTime() < deadline) {
      playOther();
      play(scene);
    }
  }

  private void playOther() {
    play(others.get(othersPlayed++ % others.size()));
  }

  private long[] play(Scene played) {
    long[] times = new long[frames];
    try (Method fresh = contender.start(played)) {
      Stopwatch.play(fresh, times);
    }
    return times;
  }

  /** The replay: the nanoseconds of each frame. */
  @Benchmark
  public long[] replay() {
    Stopwatch.play(playing, nanos);
    return nanos;
  }

  /** Keeps the frame times of a measured replay, and ends it. */
  @TearDown(Level.Iteration)
  public void keep(IterationParams iteration) {
    if (iteration.getType() == IterationType.MEASUREMENT) {
      replays.add(nanos);
    }
    playing.close();
  }

  /**
   * Measures what needs replays of its own, and hands everything over.
   *
   * @throws IOException if the samples cannot be written
   */
  @TearDown(Level.Trial)
  public void handOver() throws IOException {
    if (folder.equals(NO_FOLDER)) {
      return;
    }
    try (Method fresh = contender.start(scene)) {
      long bytes = Stopwatch.bytesAllocated(fresh, frames);
      Samples samples = new Samples(cold, replays, Stopwatch.emptyPairNanos(), bytes);
      samples.write(exchange().samples(contender, fork));
    }
  }

  private Exchange exchange() {
    return new Exchange(Path.of(folder));
  }
}
