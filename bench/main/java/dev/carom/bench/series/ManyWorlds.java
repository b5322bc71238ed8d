// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.bench.results.Row;
import java.lang.ref.Reference;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.IntStream;

/**
 * Many small worlds, one for each seed: a ball that falls among pegs into a slot. They are played
 * on one thread and on several. The hash of all must be the same.
 *
 * @param worlds how many are played in a round
 * @param rounds on each number of threads, after one to warm up
 */
public record ManyWorlds(int worlds, int rounds) {

  /** The metric of the worlds that are played in a second. */
  public static final String SPEED = "worlds_speed";

  /** The metric of the bytes of a world and its scene. */
  public static final String MEMORY = "worlds_memory";

  /** The metric of the hash of all worlds: its lower 32 bits, which a number of a row holds. */
  public static final String HASH = "worlds_hash";

  /** The name of the scene. */
  public static final String SCENE = "worlds:plinko";

  /** The prefix of the setting, before the number of threads. */
  public static final String THREADS = "threads=";

  private static final String METHOD = "carom";
  private static final int SLOTS = 17;
  private static final double SPACING = 12;
  private static final int PEG_ROWS = 12;
  private static final double END = 1000;
  private static final double GOLDEN = 0.6180339887498949;
  private static final int KEPT = 2_000;

  /**
   * Measures.
   *
   * @param threads the numbers of threads
   * @return speeds by threads, the memory of a world, and the hash
   * @throws IllegalStateException if a hash is another one
   */
  public List<Row> measure(int... threads) {
    List<Row> rows = new ArrayList<>();
    long expected = hash(1);
    double[][] speeds = new double[threads.length][rounds];
    for (int round = -1; round < rounds; round++) {
      for (int k = 0; k < threads.length; k++) {
        long begin = System.nanoTime();
        long hash = hash(threads[k]);
        double seconds = (System.nanoTime() - begin) / 1e9;
        if (hash != expected) {
          throw new IllegalStateException(
              "the hash of %d worlds on %d threads is %016x: expected %016x as on one"
                  .formatted(worlds, threads[k], hash, expected));
        }
        if (round >= 0) {
          speeds[k][round] = worlds / seconds;
        }
      }
    }
    for (int k = 0; k < threads.length; k++) {
      String knob = THREADS + threads[k];
      rows.add(row(knob, SPEED, "median", SeriesRows.median(speeds[k]), "1/s"));
      rows.add(row(knob, SPEED, "min", Arrays.stream(speeds[k]).min().orElseThrow(), "1/s"));
      rows.add(row(knob, SPEED, "max", Arrays.stream(speeds[k]).max().orElseThrow(), "1/s"));
    }
    rows.add(row("", MEMORY, "mean", bytes(), "bytes"));
    rows.add(row("", HASH, "low", (double) (expected & 0xffffffffL), "1"));
    return rows;
  }

  private Row row(String knob, String metric, String stat, double value, String unit) {
    return new Row(SCENE, METHOD, knob, metric, stat, value, unit, worlds, 0);
  }

  /** The sum of the hashes of all worlds, which does not depend on their order. */
  private long hash(int threads) {
    ForkJoinPool pool = new ForkJoinPool(threads);
    try {
      return pool.submit(() -> IntStream.range(0, worlds).parallel().mapToLong(this::play).sum())
          .get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted", e);
    } catch (ExecutionException e) {
      throw new IllegalStateException(e.getCause());
    } finally {
      pool.shutdown();
    }
  }

  private long play(int seed) {
    World world = world(seed);
    world.advanceTo(END);
    return world.snapshot().hash64();
  }

  private static World world(int seed) {
    double width = SLOTS * SPACING;
    SceneBuilder board = Scene.builder().bounds(0, 0, width, 190).gravity(0, -0.03);
    for (int row = 0; row < PEG_ROWS; row++) {
      for (double x = row % 2 == 0 ? SPACING : SPACING / 2; x < width; x += SPACING) {
        board.peg(x, 58 + 11 * row, 1.2);
      }
    }
    for (int slot = 1; slot < SLOTS; slot++) {
      board.line(slot * SPACING, 0, slot * SPACING, 46);
    }
    double x = 101 + 2 * (seed * GOLDEN % 1);
    return new World(board.circle(x, 187, 2, 0, 0).restitution(0.5).build());
  }

  /** The bytes that a world takes, with its scene. */
  private static double bytes() {
    long before = Footprint.used();
    World[] kept = IntStream.range(0, KEPT).mapToObj(ManyWorlds::world).toArray(World[]::new);
    try {
      return (double) (Footprint.used() - before) / KEPT;
    } finally {
      Reference.reachabilityFence(kept);
    }
  }
}
