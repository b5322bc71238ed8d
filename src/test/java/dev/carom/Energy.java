// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/** The kinetic energy of a world. */
public final class Energy {

  private Energy() {}

  /** The sum over all circles that are there now. */
  public static double of(World world) {
    double energy = 0;
    for (int id : world.ids(Kind.CIRCLE)) {
      double vx = world.vx(id);
      double vy = world.vy(id);
      energy += world.traits(Kind.CIRCLE, id).mass() * (vx * vx + vy * vy) / 2;
    }
    return energy;
  }
}
