// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Random;

/**
 * Scenes of circles that collide, drawn at random; overlaps are allowed, as they are in a world.
 */
public final class CollidingScenes {

  private CollidingScenes() {}

  private static double between(Random random, double low, double high) {
    return low + random.nextDouble() * (high - low);
  }

  /** Radii from 1 on and masses over six powers of ten; some rest. */
  private static void circles(SceneBuilder builder, Random random, int count, double largest) {
    for (int i = 0; i < count; i++) {
      double radius = Math.scalb(1 + random.nextDouble(), random.nextInt(i % 10 == 0 ? 7 : 4));
      radius = Math.min(largest, radius);
      boolean rests = random.nextInt(10) == 0;
      builder.circle(
          between(random, 50, 750),
          between(random, 50, 550),
          radius,
          rests ? 0 : random.nextGaussian() * 6,
          rests ? 0 : random.nextGaussian() * 6);
      switch (random.nextInt(4)) {
        case 0 -> builder.mass(Math.pow(10, between(random, -3, 3)));
        case 1 -> builder.mass(radius * radius);
        case 2 -> builder.mass(2);
        default -> builder.mass(1);
      }
    }
  }

  private static void obstacles(SceneBuilder builder, Random random, int lines, int pegs) {
    for (int i = 0; i < lines; i++) {
      double x = between(random, 0, 800);
      double y = between(random, 0, 600);
      builder.line(x, y, x + between(random, -40, 40), y + between(random, -40, 40));
    }
    for (int i = 0; i < pegs; i++) {
      builder.peg(between(random, 0, 800), between(random, 0, 600), 5 * random.nextInt(4));
    }
  }

  /** Everything at once, in bounds. */
  public static SceneBuilder mixed(Random random, int count) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 800, 600);
    obstacles(builder, random, 10, 6);
    circles(builder, random, count, 100);
    return builder;
  }

  /** Circles of three sizes that keep or lose energy, under gravity. */
  public static SceneBuilder falling(Random random, int count) {
    return inelastic(random, count).gravity(0, -0.05);
  }

  /** No bounds: circles leave for ever. */
  public static SceneBuilder open(Random random, int count) {
    SceneBuilder builder = Scene.builder();
    obstacles(builder, random, 10, 6);
    circles(builder, random, count, 60);
    return builder;
  }

  /** Circles only, of one size. */
  public static SceneBuilder gas(Random random, int count) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 400, 300);
    for (int i = 0; i < count; i++) {
      builder.circle(
          between(random, 8, 392),
          between(random, 8, 292),
          8,
          random.nextGaussian(),
          random.nextGaussian());
    }
    return builder;
  }

  /** Restitution from 0 to above 1. */
  public static SceneBuilder inelastic(Random random, int count) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 400, 300).restitution(1.05);
    double[] restitutions = {0, 0.5, 0.9, 1, 1.1};
    for (int i = 0; i < count; i++) {
      builder
          .circle(
              between(random, 8, 392),
              between(random, 8, 292),
              4 << random.nextInt(3),
              random.nextGaussian(),
              random.nextGaussian())
          .restitution(restitutions[random.nextInt(5)]);
    }
    return builder;
  }

  /** Whole numbers on a lattice: ties, exact contacts, paths along the edges of cells. */
  public static SceneBuilder lattice(Random random, int count) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 320, 320);
    for (int i = 0; i < 6; i++) {
      int x = 20 * (1 + random.nextInt(15));
      int y = 20 * (1 + random.nextInt(15));
      boolean level = random.nextBoolean();
      builder.line(x, y, level ? x + 20 : x, level ? y : y + 20);
      builder.peg(20 * (1 + random.nextInt(15)), 20 * (1 + random.nextInt(15)), 5);
    }
    double[] speeds = {-5, -2.5, 0, 2.5, 5};
    for (int i = 0; i < count; i++) {
      builder.circle(
          10 * (1 + random.nextInt(31)),
          10 * (1 + random.nextInt(31)),
          5 << random.nextInt(2),
          speeds[random.nextInt(5)],
          speeds[random.nextInt(5)]);
    }
    return builder;
  }
}
