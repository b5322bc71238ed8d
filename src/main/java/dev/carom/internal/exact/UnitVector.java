// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/** A unit vector in the plane. It can be set anew, so that many are computed without allocation. */
public final class UnitVector {

  private double x;
  private double y;

  /** A vector that is yet to be set. */
  public UnitVector() {}

  public UnitVector(double x, double y) {
    set(x, y);
  }

  public UnitVector set(double newX, double newY) {
    x = newX;
    y = newY;
    return this;
  }

  public UnitVector set(UnitVector other) {
    return set(other.x, other.y);
  }

  public double x() {
    return x;
  }

  public double y() {
    return y;
  }
}
