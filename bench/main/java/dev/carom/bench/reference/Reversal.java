// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Scene;
import dev.carom.World;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;

/**
 * Forwards some frames, all velocities turned round, and back. Elastic motion is reversible: exact
 * numbers return to their start, and numbers that are rounded as far as the scene lets them.
 *
 * @param bits how many the worst circle carried behind the point
 * @param digits the decimal digits behind the point to which all circles are proved to be back
 * @param digitsOfMore the same, where each circle carries {@link #MORE_BITS} more
 * @param returned how many circles of a {@link World}, in doubles, are back within {@link #NEAR}
 */
public record Reversal(int bits, double digits, double digitsOfMore, int returned, int circles) {

  /** In units of the scene. */
  public static final double NEAR = 1e-6;

  /** Each bit more is to bring circles nearer to their start by half. */
  public static final int MORE_BITS = 128;

  private static final int FIRST_BITS = 128;
  private static final int MOST_BITS = 1 << 15;

  private record Return(int bits, double log10, double log10OfMore) {}

  /**
   * Lets a scene go forwards and back, in as many digits as it takes and in doubles.
   *
   * @param scene any scene of circles that ignore each other and bounce elastically
   * @param frames how many, at least 1, each one unit of time
   * @param progress called once for each circle done; from any thread
   * @return how near they came
   * @throws IllegalArgumentException if something in the scene does not just bounce, circles
   *     collide, or frames is less than 1
   */
  public static Reversal of(Scene scene, int frames, Runnable progress) {
    Scope.check(scene, frames);
    if (scene.collide()) {
      throw new IllegalArgumentException("circles collide: expected ones that ignore each other");
    }
    int count = scene.circleCount();
    Map<Integer, Lookout> lookouts = new ConcurrentHashMap<>();
    Return[] returns = new Return[count];
    IntStream.range(0, count)
        .parallel()
        .forEach(
            i -> {
              returns[i] = prove(scene, i, frames, lookouts);
              progress.run();
            });
    int bits = 0;
    double worst = Double.NEGATIVE_INFINITY;
    double worstOfMore = Double.NEGATIVE_INFINITY;
    for (Return r : returns) {
      bits = Math.max(bits, r.bits);
      worst = Math.max(worst, r.log10);
      worstOfMore = Math.max(worstOfMore, r.log10OfMore);
    }
    return new Reversal(bits, -worst, -worstOfMore, inDoubles(scene, frames), count);
  }

  private static Return prove(Scene scene, int circle, int frames, Map<Integer, Lookout> lookouts) {
    for (int bits = FIRST_BITS; bits <= MOST_BITS; bits *= 2) {
      try {
        double once = thereAndBack(scene, circle, frames, bits, lookouts);
        return new Return(
            bits, once, thereAndBack(scene, circle, frames, bits + MORE_BITS, lookouts));
      } catch (DoubtException e) {
        // With more digits, then.
      }
    }
    throw new IllegalStateException(
        "circle %d: %d bits do not bring it back: expected fewer frames"
            .formatted(circle, MOST_BITS));
  }

  private static double thereAndBack(
      Scene scene, int circle, int frames, int bits, Map<Integer, Lookout> lookouts) {
    Lookout lookout = lookouts.computeIfAbsent(bits, b -> new Lookout(scene, b));
    Run run = new Run(scene, new int[] {circle}, lookout, frames, bits);
    Body body = run.body(0);
    Vec start = body.p;
    run.play();
    run.turnBack();
    run.play();
    Vec off = body.at(Ball.of(frames, bits).minus(body.t)).minus(start);
    return Math.max(off.x().log10(), off.y().log10());
  }

  private static int inDoubles(Scene scene, int frames) {
    World world = new World(scene);
    world.advanceTo(frames);
    for (int i = 0; i < scene.circleCount(); i++) {
      world.setVelocity(i, -world.vx(i), -world.vy(i));
    }
    world.advanceTo(2.0 * frames);
    int returned = 0;
    for (int i = 0; i < scene.circleCount(); i++) {
      double dx = world.x(i) - scene.circle(i).x();
      double dy = world.y(i) - scene.circle(i).y();
      returned += Math.hypot(dx, dy) <= NEAR ? 1 : 0;
    }
    return returned;
  }
}
