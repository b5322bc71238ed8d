// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Feature;
import dev.carom.Kind;
import dev.carom.Scene;

/** A line, a peg or a wall, with its numbers in so many bits. */
abstract class Target {

  final Kind kind;
  final int index;
  final int bits;
  final Ball restitution;

  Target(Scene scene, Kind kind, int index, int bits) {
    this.kind = kind;
    this.index = index;
    this.bits = bits;
    restitution = Ball.of(scene.traits(kind, index).restitution(), bits);
  }

  /**
   * When a circle at p that moves by v first touches it, as the contract has it; null for never.
   */
  abstract Touch contact(Vec p, Vec v, Ball radius);

  /**
   * When a circle that falls next touches it, until a time; null for not until then.
   *
   * @param touched the part that the circle hit at the start of its path; null for none
   */
  abstract Touch contact(Fall path, Ball radius, Ball end, Feature touched);

  /** A box around it, in plain doubles: left, bottom, right, top. Infinite for a wall. */
  abstract double[] box();

  /** From the thing to the circle that touches it at p, of any length. */
  abstract Vec normal(Vec p, Feature feature);

  /** Whether the normal turns with the place of the contact. */
  abstract boolean isRound(Feature feature);

  /** The velocity after an impact: {@code v - (1 + e) (v.n) / (n.n) n}. */
  Vec reflect(Vec v, Vec n, Ball bounce) {
    return v.minus(n.times(bounce.times(v.dot(n)).over(n.dot(n))));
  }

  /** A lower bound of the time of contact, in plain doubles; infinity for certainly never. */
  abstract double earliest(double x, double y, double vx, double vy, double radius);
}
