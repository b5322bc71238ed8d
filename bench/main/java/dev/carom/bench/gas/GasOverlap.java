// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.gas;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.World;
import java.util.Arrays;
import java.util.Comparator;

/** How deep circles of a gas reach into each other at the ends of the frames of a replay. */
public final class GasOverlap {

  private final World world;

  /** The circles from left to right: they hardly change from one frame to the next. */
  private final Integer[] order;

  private final double largest;

  private GasOverlap(World world) {
    this.world = world;
    order = new Integer[world.count(Kind.CIRCLE)];
    Arrays.setAll(order, i -> i);
    largest = Arrays.stream(order).mapToDouble(world::radius).max().orElse(0);
  }

  /**
   * Plays a scene, untimed.
   *
   * @param scene whose circles collide, or not
   * @param frameTime how long each lasts
   * @return the deepest overlap of two circles, as a part of the smaller radius; 0 if none overlap
   */
  public static double deepest(Scene scene, int frames, double frameTime) {
    World world = new World(scene);
    GasOverlap overlap = new GasOverlap(world);
    double deepest = 0;
    for (int frame = 1; frame <= frames; frame++) {
      world.advanceTo(frame * frameTime);
      deepest = Math.max(deepest, overlap.deepest());
    }
    return deepest;
  }

  private double deepest() {
    Arrays.sort(order, Comparator.comparingDouble(world::x));
    double deepest = 0;
    for (int k = 0; k < order.length; k++) {
      int i = order[k];
      double reach = world.x(i) + world.radius(i) + largest;
      for (int next = k + 1; next < order.length && world.x(order[next]) < reach; next++) {
        deepest = Math.max(deepest, overlap(i, order[next]));
      }
    }
    return deepest;
  }

  private double overlap(int i, int j) {
    double distance = Math.hypot(world.x(i) - world.x(j), world.y(i) - world.y(j));
    double gap = distance - world.radius(i) - world.radius(j);
    return -gap / Math.min(world.radius(i), world.radius(j));
  }
}
