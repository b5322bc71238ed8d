// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/** The acceleration of all circles of finite mass, which a world shares with its parts. */
public final class Gravity {

  public double x;
  public double y;

  public Gravity(double x, double y) {
    this.x = x;
    this.y = y;
  }

  /** Whether anything falls. */
  public boolean acts() {
    return x != 0 || y != 0;
  }
}
