// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * The times and the normals of straight flights in exact numbers: the last rung, where double-double
 * leaves a rounding open. Slow, some ten microseconds, and always right.
 */
public final class Exact {

  /** Bits of a vector's length before a quotient by it is rounded. */
  private static final int BITS = 128;

  private Exact() {}

  /**
   * A moving disk or sphere against a resting one. If both move, d and u are relative to
   * the second.
   */
  public record Disks(Vector d, Vector u, Dyadic r) {

    public static Disks of(
        double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
        double vx2, double vy2) {
      return of(x1, y1, 0, r1, vx1, vy1, 0, x2, y2, 0, r2, vx2, vy2, 0);
    }

    /** Spheres. */
    public static Disks of(
        double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
        double y2, double z2, double r2, double vx2, double vy2, double vz2) {
      return new Disks(
          vector(x1, y1, z1, x2, y2, z2),
          vector(vx1, vy1, vz1, vx2, vy2, vz2),
          Dyadic.of(r1).plus(Dyadic.of(r2)));
    }

    /** u.d */
    public Dyadic drift() {
      return u.x.times(d.x).plus(u.y.times(d.y)).plus(u.z.times(d.z));
    }

    /** d.d - r^2 */
    public Dyadic gap() {
      return d.square().minus(r.square());
    }

    /** (u.u) r^2 - |cross(u, d)|^2 = (u.d)^2 - (u.u) (d.d - r^2), which holds in space, too. */
    public Dyadic discriminant() {
      return drift().square().minus(u.square().times(gap()));
    }

    /** t = (-u.d - sqrt(discriminant)) / u.u, of disks that are apart and will touch. */
    public ExactTime time() {
      return new ExactTime(drift().negate(), discriminant(), u.square());
    }

    /** The unit normal at a contact to come: (d + u t) / |d + u t|, or -u / |u| for two points. */
    public UnitVector normal() {
      return r.sign() == 0
          ? unit(u.x.negate(), u.y.negate())
          : RealRoot.of(time()).unit(Polynomial.of(d.x, u.x), Polynomial.of(d.y, u.y));
    }
  }

  /**
   * The time at which a moving disk hits the side of a line that moves with the velocity u, {@code
   * t = (c - r |w|) / cv} with c = |cross(w, d)| and cv = |cross(w, v - u)|.
   */
  public static ExactTime timeOfSide(
      double px, double py, double r, double vx, double vy, double ax, double ay, double bx,
      double by, double ux, double uy) {
    Vector w = vector(bx, by, 0, ax, ay, 0);
    Dyadic c = w.cross(vector(px, py, 0, ax, ay, 0)).abs();
    Dyadic cv = w.cross(vector(vx, vy, 0, ux, uy, 0)).abs();
    return new ExactTime(c, w.square().times(Dyadic.of(r).square()), cv);
  }

  /**
   * The time at which a disk with the velocity v hits a wall, {@code t = (|p - wall| - r) / |v|}.
   * It is below 0 if it overlaps the wall on the side from which it comes, or is beyond it.
   */
  public static ExactTime timeOfWall(double p, double r, double v, double wall) {
    Dyadic s = v < 0 ? Dyadic.difference(p, wall) : Dyadic.difference(wall, p);
    return new ExactTime(s.minus(Dyadic.of(r)), Dyadic.ZERO, Dyadic.of(v).abs());
  }

  /** (a - b) / |a - b|. */
  public static UnitVector unit(double ax, double ay, double bx, double by) {
    return unit(Dyadic.difference(ax, bx), Dyadic.difference(ay, by));
  }

  /** (x, y) / |(x, y)|. */
  static UnitVector unit(Dyadic x, Dyadic y) {
    Dyadic length = x.square().plus(y.square()).sqrt(BITS);
    return new UnitVector(quotient(x, length), quotient(y, length));
  }

  private static double quotient(Dyadic a, Dyadic length) {
    return a.sign() == 0 ? 0 : a.sign() * a.abs().over(length, BITS).floor();
  }

  private static Vector vector(
      double ax, double ay, double az, double bx, double by, double bz) {
    return new Vector(
        Dyadic.difference(ax, bx), Dyadic.difference(ay, by), Dyadic.difference(az, bz));
  }

  /** A vector of exact numbers; z is 0 in the plane. */
  private record Vector(Dyadic x, Dyadic y, Dyadic z) {

    Dyadic square() {
      return x.square().plus(y.square()).plus(z.square());
    }

    /** The cross product with a vector, both in the plane. */
    Dyadic cross(Vector b) {
      return x.times(b.y).minus(y.times(b.x));
    }
  }
}
