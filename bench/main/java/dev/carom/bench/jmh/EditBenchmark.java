// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.jmh;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Snapshot;
import dev.carom.Timeline;
import dev.carom.World;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.experiment.Gas;
import dev.carom.bench.experiment.SceneCopy;
import dev.carom.bench.experiment.Tiles;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.SplittableRandom;
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

/** Edits, snapshots and timelines. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(2)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class EditBenchmark {

  /** The recorded time of the gas. */
  static final double PAST = 5;

  /** So many moments of that time are asked for in turn, evenly spaced. */
  static final int MOMENTS = 997;

  /** Times the canonical scene, side by side, in each direction: 10^4 circles, 10^4 lines. */
  private static final int TILES = 10;

  private static final double WIDTH = 800;
  private static final double HEIGHT = 600;

  /** A world whose circles all get a new velocity in each frame. */
  @State(Scope.Thread)
  public static class Steered {

    World world;
    double[] velocities;
    int frame;

    /**
     * Starts the world.
     *
     * @throws CannotPlaceException never, for these scenes
     */
    @Setup(Level.Iteration)
    public void start() throws CannotPlaceException {
      start(TILES);
    }

    void start(int tiles) throws CannotPlaceException {
      world = new World(new Tiles(tiles, true, 1).scene());
      SplittableRandom random = new SplittableRandom(1);
      velocities = random.doubles(1 << 16, -7, 7).toArray();
    }

    void steerOne() {
      int k = 17 * frame++;
      int circle = Math.floorMod(k, world.count(Kind.CIRCLE));
      world.setVelocity(circle, velocities[k & 0xffff], velocities[k + 1 & 0xffff]);
    }

    void steer() {
      int k = 17 * frame++;
      for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
        world.setVelocity(i, velocities[k++ & 0xffff], velocities[k++ & 0xffff]);
      }
    }
  }

  /** A thousand circles: alone among a thousand lines, or a gas. */
  @State(Scope.Thread)
  public static class Thousand {

    World alone;
    World gas;
    Snapshot ofAlone;
    Snapshot ofGas;
    byte[] bytesOfGas;
    Timeline pastOfGas;
    int next;

    /**
     * Starts the worlds.
     *
     * @throws CannotPlaceException never, for these scenes
     * @throws IOException never
     */
    @Setup(Level.Iteration)
    public void start() throws CannotPlaceException, IOException {
      Scene lines = Crosses.canonical(1).scene();
      Scene circles = new Crosses(1000, 0, 3, 1, 10, 1).scene();
      alone = new World(SceneCopy.circles(SceneCopy.obstacles(lines), circles).build());
      gas = new World(new Gas(1000, 0.3, 1, false, 1).scene());
      pastOfGas = gas.record(1000);
      alone.step(50);
      gas.step(PAST);
      pastOfGas.stop();
      ofAlone = alone.snapshot();
      ofGas = gas.snapshot();
      ByteArrayOutputStream out = new ByteArrayOutputStream();
      ofGas.write(out);
      bytesOfGas = out.toByteArray();
    }
  }

  /** 600 recorded frames of the canonical scene, and moments in them at random. */
  @State(Scope.Thread)
  public static class Recorded {

    World recording;
    World plain;
    Timeline timeline;
    double[] moments;
    int next;

    /**
     * Records.
     *
     * @throws CannotPlaceException never, for this scene
     */
    @Setup(Level.Iteration)
    public void record() throws CannotPlaceException {
      plain = new World(Crosses.canonical(1).scene());
      recording = new World(plain.scene());
      recording.record(10_000);
      World done = new World(plain.scene());
      timeline = done.record(10_000);
      for (int i = 0; i < 600; i++) {
        done.step(1);
      }
      moments = new SplittableRandom(1).doubles(1 << 12, 0, 600).toArray();
    }
  }

  /** A circle in bounds, among pegs of which two are paddles. */
  @State(Scope.Thread)
  public static class Paddles {

    /** How many pegs there are. */
    @Param({"2", "10", "1000"})
    int pegs;

    World world;
    int frame;

    /** Starts the world. */
    @Setup(Level.Iteration)
    public void start() {
      SceneBuilder builder = Scene.builder().bounds(0, 0, WIDTH, HEIGHT);
      builder.peg(200, 300, 10).peg(600, 300, 10);
      for (int i = 2; i < pegs; i++) {
        builder.peg(10 + i % 40 * 18, 400 + i / 40 * 6, 1);
      }
      world = new World(builder.circle(400, 100, 10, 4, 3).build());
    }

    /** A component of a velocity that keeps a paddle near its place. */
    double toAndFro(double speed, int later) {
      return (frame + later) % 20 < 10 ? speed : -speed;
    }
  }

  /**
   * A frame in which nothing was edited.
   *
   * @param s the world
   */
  @Benchmark
  public void paddlesRest(Paddles s) {
    s.world.step(1);
  }

  /**
   * The velocities of both paddles set, and a frame.
   *
   * @param s the world
   */
  @Benchmark
  public void paddlesMove(Paddles s) {
    s.frame++;
    for (int id = 0; id < 2; id++) {
      s.world.setVelocity(Kind.PEG, id, s.toAndFro(0.1, 0), s.toAndFro(0.07, 5));
    }
    s.world.step(1);
  }

  /**
   * Both paddles placed, and a frame.
   *
   * @param s the world
   */
  @Benchmark
  public void paddlesJump(Paddles s) {
    s.frame++;
    for (int id = 0; id < 2; id++) {
      s.world.setShape(
          Kind.PEG, id, new Circle(200 + 400 * id + s.toAndFro(1, 0), 300 + s.toAndFro(1, 5), 10));
    }
    s.world.step(1);
  }

  /**
   * The velocity of the circle set, and a frame.
   *
   * @param s the world
   */
  @Benchmark
  public void circleSteered(Paddles s) {
    s.frame++;
    s.world.setVelocity(0, s.toAndFro(4, 0), s.toAndFro(3, 5));
    s.world.step(1);
  }

  /**
   * All velocities set, and a frame.
   *
   * @param s the world
   */
  @Benchmark
  public void steer(Steered s) {
    s.steer();
    s.world.step(1);
  }

  /**
   * One velocity set, and a frame.
   *
   * @param s the world
   */
  @Benchmark
  public void steerOne(Steered s) {
    s.steerOne();
    s.world.step(1);
  }

  /** One velocity set. */
  @Benchmark
  public World setVelocity(Steered s) {
    s.steerOne();
    return s.world;
  }

  /**
   * A snapshot of 1,000 circles that ignore each other.
   *
   * @param s the worlds
   */
  @Benchmark
  public Snapshot snapshotAlone(Thousand s) {
    return s.alone.snapshot();
  }

  /**
   * A snapshot of 1,000 circles that collide.
   *
   * @param s the worlds
   */
  @Benchmark
  public Snapshot snapshotGas(Thousand s) {
    return s.gas.snapshot();
  }

  /**
   * The hash of a snapshot of 1,000 circles.
   *
   * @param s the worlds
   */
  @Benchmark
  public long hashGas(Thousand s) {
    return s.ofGas.hash64();
  }

  /**
   * A snapshot of 1,000 circles, written.
   *
   * @param s the worlds
   * @throws IOException never
   */
  @Benchmark
  public byte[] writeGas(Thousand s) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    s.ofGas.write(out);
    return out.toByteArray();
  }

  /**
   * A snapshot of 1,000 circles, read.
   *
   * @param s the worlds
   * @throws IOException never
   */
  @Benchmark
  public Snapshot readGas(Thousand s) throws IOException {
    return Snapshot.read(new ByteArrayInputStream(s.bytesOfGas));
  }

  /**
   * A snapshot of 1,000 circles that collide, at a moment of the past.
   *
   * @param s the worlds
   */
  @Benchmark
  public Snapshot pastGas(Thousand s) {
    return s.pastOfGas.snapshot(s.next++ % MOMENTS * PAST / MOMENTS);
  }

  /** Back to where the snapshot was taken. */
  @Benchmark
  public World restoreAlone(Thousand s) {
    s.alone.restore(s.ofAlone);
    return s.alone;
  }

  /** Back to where the snapshot was taken. */
  @Benchmark
  public World restoreGas(Thousand s) {
    s.gas.restore(s.ofGas);
    return s.gas;
  }

  /**
   * The same with the step after it, which searches for every circle.
   *
   * @param s the worlds
   */
  @Benchmark
  public void restoreAndStepAlone(Thousand s) {
    s.alone.restore(s.ofAlone);
    s.alone.step(0.01);
  }

  /**
   * The same with the step after it, which foresees everything anew.
   *
   * @param s the worlds
   */
  @Benchmark
  public void restoreAndStepGas(Thousand s) {
    s.gas.restore(s.ofGas);
    s.gas.step(0.01);
  }

  /**
   * Where all 100 circles were at one moment.
   *
   * @param s the recording
   * @return a sum of what was found
   */
  @Benchmark
  public double lookUp(Recorded s) {
    double t = s.moments[s.next++ & 0xfff];
    double sum = 0;
    for (int i = 0; i < 100; i++) {
      sum += s.timeline.x(i, t) + s.timeline.y(i, t);
    }
    return sum;
  }

  /**
   * A frame of the canonical scene.
   *
   * @param s the worlds
   */
  @Benchmark
  public void frame(Recorded s) {
    s.plain.step(1);
  }

  /**
   * A frame of the canonical scene that is recorded.
   *
   * @param s the worlds
   */
  @Benchmark
  public void frameRecorded(Recorded s) {
    s.recording.step(1);
  }
}
