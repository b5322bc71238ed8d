// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Feature;
import dev.carom.ObstacleKind;

/** A line, a peg or a wall, with its numbers in so many bits. */
interface Target {

  ObstacleKind kind();

  int index();

  Ball restitution();

  /**
   * When a circle at p that moves by v first touches it, as the contract has it; null for never.
   */
  Contact contact(Vec p, Vec v, Ball radius);

  /** From the thing to the circle that touches it at p, of any length. */
  Vec normal(Vec p, Feature feature);

  /** Whether the normal turns with the place of the contact. */
  boolean isRound(Feature feature);

  /** The velocity after an impact: {@code v - (1 + e) (v.n) / (n.n) n}. */
  default Vec reflect(Vec v, Vec n, Ball bounce) {
    return v.minus(n.times(bounce.times(v.dot(n)).over(n.dot(n))));
  }

  /** A lower bound of the time of contact, in plain doubles; infinity for certainly never. */
  double earliest(double x, double y, double vx, double vy, double radius);
}
