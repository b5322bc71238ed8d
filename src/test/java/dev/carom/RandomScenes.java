// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Random;

/** Scenes drawn at random; overlaps are allowed, as they are in a world. */
public final class RandomScenes {

  private RandomScenes() {}

  /** Draws the parts of one kind of scene. */
  public interface Recipe {
    SceneBuilder draw(Random random);
  }

  private static double between(Random random, double low, double high) {
    return low + random.nextDouble() * (high - low);
  }

  private static void lines(SceneBuilder builder, Random random, int count, double length) {
    for (int i = 0; i < count; i++) {
      double x = between(random, 0, 800);
      double y = between(random, 0, 600);
      builder.line(
          x, y, x + between(random, -length, length), y + between(random, -length, length));
    }
  }

  private static void pegs(SceneBuilder builder, Random random, int count, double radius) {
    for (int i = 0; i < count; i++) {
      builder.peg(between(random, 0, 800), between(random, 0, 600), random.nextInt(4) * radius / 3);
    }
  }

  /** Radii from 1 to the largest one, each power of two about as often. */
  private static void circles(SceneBuilder builder, Random random, int count, double largest) {
    for (int i = 0; i < count; i++) {
      double radius = Math.scalb(1 + random.nextDouble(), random.nextInt(7)) % largest + 1;
      builder.circle(
          between(random, 50, 750),
          between(random, 50, 550),
          radius,
          random.nextGaussian() * 6,
          random.nextGaussian() * 6);
    }
  }

  /** Short lines and pegs in bounds. */
  public static SceneBuilder mixed(Random random) {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, 800, 600);
    lines(builder, random, 60, 30);
    pegs(builder, random, 40, 12);
    circles(builder, random, 60, 20);
    return builder;
  }

  /** A few lines right across, others axis-parallel, some points. */
  public static SceneBuilder longLines(Random random) {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, 800, 600);
    lines(builder, random, 8, 900);
    for (int i = 0; i < 12; i++) {
      double x = Math.rint(between(random, 0, 800));
      double y = Math.rint(between(random, 0, 600));
      builder.line(x, y, x + 200 * (i % 2), y + 200 * (i / 2 % 2));
    }
    circles(builder, random, 60, 12);
    return builder;
  }

  /** As mixed, each line and peg with a response of its own, some lines one-way. */
  public static SceneBuilder responses(Random random) {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, 800, 600);
    Response[] responses = Response.values();
    for (int i = 0; i < 60; i++) {
      lines(builder, random, 1, 90);
      builder.response(responses[random.nextInt(8) == 0 ? 1 : random.nextInt(2) * 2]);
      if (random.nextInt(3) == 0) {
        builder.oneWay();
      }
    }
    for (int i = 0; i < 40; i++) {
      pegs(builder, random, 1, 25);
      builder.response(responses[random.nextInt(8) == 0 ? 1 : random.nextInt(2) * 2]);
    }
    circles(builder, random, 60, 20);
    return builder;
  }

  /** Radii from 1 to 100 among few obstacles. */
  public static SceneBuilder mixedRadii(Random random) {
    SceneBuilder builder = Scene.builder().collide(false).bounds(-200, -200, 1000, 800);
    lines(builder, random, 15, 60);
    pegs(builder, random, 5, 30);
    circles(builder, random, 80, 99);
    return builder;
  }

  /** Circles that fall among lines and pegs, some of which take energy, and settle on the floor. */
  public static SceneBuilder falling(Random random) {
    SceneBuilder builder = Scene.builder().collide(false).gravity(0, -0.5);
    builder.bounds(0, 0, 800, 600).restitution(0.5);
    for (int i = 0; i < 30; i++) {
      lines(builder, random, 1, 90);
      builder.restitution(random.nextInt(3) / 2.0);
      pegs(builder, random, 1, 25);
      builder.restitution(random.nextInt(3) / 2.0);
    }
    circles(builder, random, 40, 20);
    return builder;
  }

  /** No bounds; circles come from far away, some past everything, some never. */
  public static SceneBuilder open(Random random) {
    SceneBuilder builder = Scene.builder().collide(false);
    lines(builder, random, 60, 50);
    pegs(builder, random, 30, 12);
    for (int i = 0; i < 100; i++) {
      double angle = random.nextDouble() * 2 * Math.PI;
      double distance = between(random, 500, 1e5);
      double x = 400 + distance * Math.cos(angle);
      double y = 300 + distance * Math.sin(angle);
      double duration = between(random, 100, 500);
      double radius = between(random, 1, 40);
      double aimX = between(random, 0, 800);
      double aimY = between(random, 0, 600);
      if (i % 5 == 0) {
        builder.circle(x, y, radius, 0, aimY - y > 0 ? 30 : -30);
      } else {
        builder.circle(x, y, radius, (aimX - x) / duration, (aimY - y) / duration);
      }
    }
    return builder;
  }

  /** Whole numbers on a lattice: ties, joints, exact contacts, paths along the edges of cells. */
  public static SceneBuilder lattice(Random random) {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, 640, 640);
    for (int i = 0; i < 80; i++) {
      int x = 20 * (1 + random.nextInt(30));
      int y = 20 * (1 + random.nextInt(30));
      boolean level = random.nextBoolean();
      builder.line(x, y, level ? x + 20 : x, level ? y : y + 20);
    }
    for (int i = 0; i < 10; i++) {
      builder.peg(20 * (1 + random.nextInt(30)), 20 * (1 + random.nextInt(30)), 5);
    }
    for (int i = 0; i < 60; i++) {
      int x = 10 * (1 + random.nextInt(62));
      int y = 10 * (1 + random.nextInt(62));
      double[] speeds = {-5, -2.5, 0, 2.5, 5};
      builder.circle(
          x, y, 5 << random.nextInt(2), speeds[random.nextInt(5)], speeds[random.nextInt(5)]);
    }
    return builder;
  }

  // Circles that collide.

  /** Radii from 1 on and masses over six powers of ten among a few obstacles; some rest. */
  public static SceneBuilder crowd(Random random, int count) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 800, 600);
    lines(builder, random, 10, 40);
    pegs(builder, random, 6, 15);
    for (int i = 0; i < count; i++) {
      double radius = Math.scalb(1 + random.nextDouble(), random.nextInt(i % 10 == 0 ? 7 : 4));
      boolean rests = random.nextInt(10) == 0;
      builder.circle(
          between(random, 50, 750),
          between(random, 50, 550),
          Math.min(100, radius),
          rests ? 0 : random.nextGaussian() * 6,
          rests ? 0 : random.nextGaussian() * 6);
      switch (random.nextInt(4)) {
        case 0 -> builder.mass(Math.pow(10, between(random, -3, 3)));
        case 1 -> builder.mass(radius * radius);
        case 2 -> builder.mass(2);
        default -> builder.mass(1);
      }
    }
    return builder;
  }

  /** Circles only, of one size. */
  public static SceneBuilder gas(Random random, int count) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 400, 300);
    for (int i = 0; i < count; i++) {
      double x = between(random, 8, 392);
      double y = between(random, 8, 292);
      builder.circle(x, y, 8, random.nextGaussian(), random.nextGaussian());
    }
    return builder;
  }

  /** A gas of three sizes, with restitutions from 0 to above 1. */
  public static SceneBuilder inelastic(Random random, int count) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 400, 300).restitution(1.05);
    double[] restitutions = {0, 0.5, 0.9, 1, 1.1};
    for (int i = 0; i < count; i++) {
      double x = between(random, 8, 392);
      double y = between(random, 8, 292);
      int radius = 4 << random.nextInt(3);
      builder.circle(x, y, radius, random.nextGaussian(), random.nextGaussian());
      builder.restitution(restitutions[random.nextInt(5)]);
    }
    return builder;
  }
}
