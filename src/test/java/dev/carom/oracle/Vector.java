// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** An exact vector of the plane. */
record Vector(Dyadic x, Dyadic y) {

  static Vector of(double x, double y) {
    return new Vector(Dyadic.of(x), Dyadic.of(y));
  }

  Vector plus(Vector other) {
    return new Vector(x.plus(other.x), y.plus(other.y));
  }

  Vector minus(Vector other) {
    return new Vector(x.minus(other.x), y.minus(other.y));
  }

  Vector times(Dyadic factor) {
    return new Vector(x.times(factor), y.times(factor));
  }

  Vector negate() {
    return new Vector(x.negate(), y.negate());
  }

  /** This vector turned left by 90 degrees. */
  Vector turned() {
    return new Vector(y.negate(), x);
  }

  Dyadic dot(Vector other) {
    return x.times(other.x).plus(y.times(other.y));
  }

  /** x1 y2 - y1 x2: positive if the other vector points to the left of this one. */
  Dyadic cross(Vector other) {
    return x.times(other.y).minus(y.times(other.x));
  }

  Dyadic squared() {
    return dot(this);
  }

  boolean isZero() {
    return x.signum() == 0 && y.signum() == 0;
  }
}
