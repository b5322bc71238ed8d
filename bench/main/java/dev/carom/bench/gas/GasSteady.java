// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.gas;

import com.sun.management.ThreadMXBean;
import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.World;
import java.lang.management.ManagementFactory;
import java.util.Arrays;

/**
 * A gas in its steady state: one world that goes on and on, timed in rounds once it has forgotten
 * the lattice from which it started and the virtual machine has compiled what it does.
 *
 * @param median nanoseconds per collision over the rounds: what its steps took, without reading the
 *     log
 * @param collisions of all rounds together
 * @param frames of all rounds together
 * @param bytes allocated in the steps of the last round
 */
public record GasSteady(
    double median, double least, double most, long collisions, long frames, long bytes) {

  /** Collisions before the first round: so many, and so many for each circle. */
  private static final long WARM_UP = 3_000_000;

  private static final int WARM_UP_PER_CIRCLE = 5;

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  /** Frames, their collisions, and what their steps took. */
  private static final class Round {
    private final World world;
    private long frames;
    private long collisions;
    private long nanos;
    private long bytes;

    Round(World world) {
      this.world = world;
    }

    Round play(long enough) {
      while (collisions < enough) {
        step(Math.floor(world.now()) + 1);
        frames++;
      }
      return this;
    }

    private void step(double end) {
      long asked = THREADS.getCurrentThreadAllocatedBytes();
      long before = THREADS.getCurrentThreadAllocatedBytes();
      long start = System.nanoTime();
      world.advanceTo(end);
      nanos += System.nanoTime() - start;
      bytes += THREADS.getCurrentThreadAllocatedBytes() - before - (before - asked);
      ImpactLog log = world.impacts();
      for (int row = 0; row < log.size(); row++) {
        collisions += log.kind(row) == Kind.CIRCLE ? 1 : 0;
      }
    }
  }

  /**
   * Plays a scene in which circles collide again and again.
   *
   * @param rounds how many rounds, at least 1
   * @param collisions of one round, at least; it ends with a frame
   * @return what the rounds took
   */
  public static GasSteady play(Scene scene, int rounds, long collisions) {
    World world = new World(scene);
    new Round(world).play(Math.max(WARM_UP, (long) WARM_UP_PER_CIRCLE * scene.count(Kind.CIRCLE)));
    double[] nanos = new double[rounds];
    long all = 0;
    long frames = 0;
    long bytes = 0;
    for (int i = 0; i < rounds; i++) {
      Round round = new Round(world).play(collisions);
      nanos[i] = (double) round.nanos / round.collisions;
      all += round.collisions;
      frames += round.frames;
      bytes = round.bytes;
    }
    Arrays.sort(nanos);
    return new GasSteady(nanos[rounds / 2], nanos[0], nanos[rounds - 1], all, frames, bytes);
  }
}
