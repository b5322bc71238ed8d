// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.World;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * A scene whose circles ignore each other, split over threads: each has a world of its own, made of
 * the same scene, from which the circles of the others are removed. The worlds share the scene's
 * lines and pegs, circles keep their ids, and every impact is that of one world, to the bit: no
 * circle depends on another.
 *
 * <p>A world belongs to one thread at a time; the pool hands it from frame to frame. For one scene
 * with circles that collide there is no such split.
 */
public final class SplitWorld implements AutoCloseable {

  private final List<World> parts = new ArrayList<>();
  private final ExecutorService pool;

  /**
   * Splits a scene.
   *
   * @param scene its circles must ignore each other
   * @param threads how many, at least 1
   * @throws IllegalArgumentException if circles collide, or there is no thread
   */
  public SplitWorld(Scene scene, int threads) {
    if (scene.collide() && scene.count(Kind.CIRCLE) > 1) {
      throw new IllegalArgumentException(
          "the circles of the scene collide: expected circles that ignore each other");
    }
    if (threads < 1) {
      throw new IllegalArgumentException("threads is " + threads + ": expected at least 1");
    }
    int circles = scene.count(Kind.CIRCLE);
    for (int k = 0; k < threads; k++) {
      int from = (int) ((long) circles * k / threads);
      int to = (int) ((long) circles * (k + 1) / threads);
      parts.add(part(scene, from, to));
    }
    pool = Executors.newFixedThreadPool(threads, SplitWorld::daemon);
  }

  private static World part(Scene scene, int from, int to) {
    World part = new World(scene);
    for (int id = 0; id < scene.count(Kind.CIRCLE); id++) {
      if (id < from || id >= to) {
        part.remove(Kind.CIRCLE, id);
      }
    }
    return part;
  }

  private static Thread daemon(Runnable work) {
    Thread thread = new Thread(work, "carom-part");
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Lets all parts go on at once, and waits for the last.
   *
   * @param t as for {@link World#advanceTo(double)}
   * @throws InterruptedException if this thread is interrupted while it waits
   * @throws ExecutionException if a part failed, or did not get there within its budget of work
   */
  public void advanceTo(double t) throws InterruptedException, ExecutionException {
    List<Callable<Object>> calls = new ArrayList<>();
    for (World part : parts) {
      calls.add(Executors.callable(() -> part.advanceTo(t)));
    }
    for (Future<?> call : pool.invokeAll(calls)) {
      call.get();
    }
  }

  /**
   * The parts, in the order of their circles: one world a thread; each contains its own circles
   * only.
   */
  public List<World> parts() {
    return List.copyOf(parts);
  }

  /** Ends the threads. */
  @Override
  public void close() {
    pool.shutdownNow();
  }
}
