// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

/** A point or a vector of the plane. */
record Vec(Ball x, Ball y) {

  static Vec of(double x, double y, int bits) {
    return new Vec(Ball.of(x, bits), Ball.of(y, bits));
  }

  Vec plus(Vec v) {
    return new Vec(x.plus(v.x), y.plus(v.y));
  }

  Vec minus(Vec v) {
    return new Vec(x.minus(v.x), y.minus(v.y));
  }

  Vec times(Ball factor) {
    return new Vec(x.times(factor), y.times(factor));
  }

  Vec negate() {
    return new Vec(x.negate(), y.negate());
  }

  Ball dot(Vec v) {
    return x.times(v.x).plus(y.times(v.y));
  }

  Ball cross(Vec v) {
    return x.times(v.y).minus(y.times(v.x));
  }

  /** {@code |x| + |y|}, in plain doubles. */
  double size() {
    return Math.abs(x.head()) + Math.abs(y.head());
  }

  /** A quarter turn to the left. */
  Vec left() {
    return new Vec(y.negate(), x);
  }
}
