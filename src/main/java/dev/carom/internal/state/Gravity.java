// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/** The acceleration of all circles of finite mass, which a world shares with its parts. */
public final class Gravity {

  public double x;
  public double y;

  /** Kept, as each collision asks for it. */
  private double size;

  public Gravity(double x, double y) {
    set(x, y);
  }

  /** Sets all three numbers; nothing else writes them. */
  public void set(double gx, double gy) {
    x = gx;
    y = gy;
    size = StrictMath.hypot(gx, gy);
  }

  public double size() {
    return size;
  }

  /** Whether anything falls. */
  public boolean acts() {
    return x != 0 || y != 0;
  }
}
