// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** How near a straight flight comes to what is in its way, exactly. */
public final class Passage {
  private final Vector p;
  private final Vector q;

  private Passage(Vector p, Vector q) {
    this.p = p;
    this.q = q;
  }

  /** A flight of a centre from one place to another. */
  public static Passage of(double px, double py, double qx, double qy) {
    return new Passage(Vector.of(px, py), Vector.of(qx, qy));
  }

  /** The same flight as it is seen from another centre, which flies in the same time. */
  public Passage seenFrom(Passage other) {
    return new Passage(p.minus(other.p), q.minus(other.q));
  }

  /**
   * Whether it comes nearer to the line a-b than a limit, which is more than 0: it meets the line,
   * or one of the four ends is nearer to the other of the two.
   */
  public boolean comesNearer(double ax, double ay, double bx, double by, double limit) {
    Vector a = Vector.of(ax, ay);
    Vector b = Vector.of(bx, by);
    Dyadic square = Dyadic.of(limit).square();
    return crosses(a, b)
        || isNearer(p, a, b, square)
        || isNearer(q, a, b, square)
        || isNearer(a, p, q, square)
        || isNearer(b, p, q, square);
  }

  /**
   * Whether it goes through the line a-b, from one side strictly to the other, between its ends.
   */
  public boolean crosses(double ax, double ay, double bx, double by) {
    return crosses(Vector.of(ax, ay), Vector.of(bx, by));
  }

  private boolean crosses(Vector a, Vector b) {
    return side(a, b, p) * side(a, b, q) < 0 && side(p, q, a) * side(p, q, b) < 0;
  }

  /** 1 if c is left of the way from a to b, -1 if it is right of it. */
  private static int side(Vector a, Vector b, Vector c) {
    return b.minus(a).cross(c.minus(a)).signum();
  }

  /** Whether the distance of c from a-b, squared, is less than a limit. */
  private static boolean isNearer(Vector c, Vector a, Vector b, Dyadic square) {
    Vector d = c.minus(a);
    Vector w = b.minus(a);
    Dyadic along = d.dot(w);
    if (along.signum() <= 0) {
      return d.squared().compareTo(square) < 0;
    }
    if (along.compareTo(w.squared()) >= 0) {
      return d.minus(w).squared().compareTo(square) < 0;
    }
    return w.cross(d).square().compareTo(square.times(w.squared())) < 0;
  }
}
