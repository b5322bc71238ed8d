// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.gas;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.World;

/**
 * One timed replay of a scene whose circles collide.
 *
 * @param nanos what its steps took, without building the world and reading its log
 * @param collisions between circles
 * @param energyChange of the kinetic energy, relative to what it was
 */
public record GasReplay(long nanos, long collisions, long wallImpacts, double energyChange) {

  /**
   * Plays a scene once.
   *
   * @param scene whose circles collide
   * @param frameTime how long each lasts
   * @return what it took, and what happened
   */
  public static GasReplay play(Scene scene, int frames, double frameTime) {
    World world = new World(scene);
    double before = energy(scene, world);
    long nanos = 0;
    long collisions = 0;
    long wallImpacts = 0;
    for (int frame = 1; frame <= frames; frame++) {
      long start = System.nanoTime();
      world.advanceTo(frame * frameTime);
      nanos += System.nanoTime() - start;
      ImpactLog log = world.impacts();
      for (int row = 0; row < log.size(); row++) {
        collisions += log.kind(row) == Kind.CIRCLE ? 1 : 0;
        wallImpacts += log.kind(row) == Kind.WALL ? 1 : 0;
      }
    }
    return new GasReplay(nanos, collisions, wallImpacts, energy(scene, world) / before - 1);
  }

  private static double energy(Scene scene, World world) {
    double energy = 0;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      double vx = world.vx(i);
      double vy = world.vy(i);
      energy += scene.traits(Kind.CIRCLE, i).mass() * (vx * vx + vy * vy) / 2;
    }
    return energy;
  }
}
