// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.methods.PlainScene;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;

/**
 * The true course of a scene, computed: an event-driven run in so many digits that each decision is
 * proved and each state known to its last place. The digits are doubled until that is so, and once
 * more for a run that must agree. Circles that ignore each other are run each with its own digits.
 */
public final class Truth implements Reference {

  private final int frames;
  private final Vec2 gravity;
  private final CircleFrames[] courses;
  private final List<Proof> proofs;

  private Truth(int frames, Vec2 gravity, CircleFrames[] courses, List<Proof> proofs) {
    this.frames = frames;
    this.gravity = gravity;
    this.courses = courses;
    this.proofs = proofs;
  }

  /**
   * Computes the course of a scene, on all cores.
   *
   * @param scene any scene whose things all bounce, from both sides, and whose impacts do not pile
   *     up; its circles may collide, if there is no gravity
   * @param frames how many, at least 1, each one unit of time
   * @param progress called once a group: each circle, or all that collide; from any thread
   * @throws IllegalArgumentException if something in the scene does not just bounce, or frames is
   *     less than 1
   * @throws IllegalStateException if impacts pile up, or 32,768 bits do not decide what happens
   */
  public static Truth of(Scene scene, int frames, Runnable progress) {
    Scope.check(scene, frames);
    int count = scene.count(Kind.CIRCLE);
    int[] all = IntStream.range(0, count).toArray();
    int[][] groups =
        PlainScene.collides(scene)
            ? new int[][] {all}
            : IntStream.of(all).mapToObj(i -> new int[] {i}).toArray(int[][]::new);
    Map<Integer, Lookout> lookouts = new ConcurrentHashMap<>();
    Proof[] proofs = new Proof[groups.length];
    IntStream.range(0, groups.length)
        .parallel()
        .forEach(
            g -> {
              proofs[g] =
                  Proof.of(
                      scene,
                      groups[g],
                      bits -> lookouts.computeIfAbsent(bits, b -> new Lookout(scene, b)),
                      frames);
              progress.run();
            });
    CircleFrames[] courses = new CircleFrames[count];
    for (int g = 0; g < groups.length; g++) {
      for (int i = 0; i < groups[g].length; i++) {
        courses[groups[g][i]] = proofs[g].courses().get(i);
      }
    }
    return new Truth(frames, scene.gravity(), courses, List.of(proofs));
  }

  @Override
  public int frames() {
    return frames;
  }

  @Override
  public int circles() {
    return courses.length;
  }

  @Override
  public double x(int frame, int circle) {
    return courses[circle].states[frame][0];
  }

  @Override
  public double y(int frame, int circle) {
    return courses[circle].states[frame][1];
  }

  @Override
  public double vx(int frame, int circle) {
    return courses[circle].states[frame][2];
  }

  @Override
  public double vy(int frame, int circle) {
    return courses[circle].states[frame][3];
  }

  @Override
  public double log10Conditioning(int frame, int circle) {
    double log = courses[circle].conditioning[frame];
    return log > 300 ? Double.POSITIVE_INFINITY : log;
  }

  /** One proof a circle, or a single one if they collide. */
  List<Proof> proofs() {
    return proofs;
  }

  /** The number of impacts in all frames, one for both circles of a pair: at least 0. */
  public int impacts() {
    return proofs.stream().mapToInt(proof -> proof.hits().size()).sum();
  }

  /**
   * The number of impacts of one circle in all frames, of a scene whose circles ignore each other:
   * at least 0.
   */
  public int impacts(int circle) {
    return proofs.get(circle).hits().size();
  }

  /**
   * How many binary digits behind the point were enough: one number a circle, or a single one if
   * they collide, in increasing order.
   */
  public int[] neededBits() {
    return proofs.stream().mapToInt(Proof::needed).sorted().toArray();
  }

  /**
   * How much the scene multiplies relative errors until the last frame, for the worst circle: the
   * base-10 logarithm, also beyond 300.
   */
  public double worstLog10Conditioning() {
    return Arrays.stream(courses).mapToDouble(c -> c.conditioning[frames]).max().orElse(0);
  }

  double[] gravity() {
    return new double[] {gravity.x(), gravity.y()};
  }

  CircleFrames course(int circle) {
    return courses[circle];
  }
}
