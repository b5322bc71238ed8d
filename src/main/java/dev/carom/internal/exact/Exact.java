// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;


/**
 * The highest precision: the polynomials of a sweep in exact numbers, and times of impact with any
 * number of digits. Slow (some microseconds) and always right.
 */
public final class Exact {

  /** Bits of a time of impact before it is rounded. */
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
      return new Disks(vector(x1, y1, x2, y2), vector(vx1, vy1, vx2, vy2), sum(r1, r2));
    }

    /** Spheres. */
    public static Disks of(
        double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
        double y2, double z2, double r2, double vx2, double vy2, double vz2) {
      return new Disks(
          vector(x1, y1, x2, y2).above(Dyadic.difference(z1, z2)),
          vector(vx1, vy1, vx2, vy2).above(Dyadic.difference(vz1, vz2)),
          sum(r1, r2));
    }

    /**
     * The sign of t - m for the time of impact t: -1 if the distance rises at m, else the sign of
     * the polynomial at m.
     */
    public int compareTime(Dyadic m) {
      if (dot(u, d).plus(u.square().times(m)).sign() > 0) {
        return -1;
      }
      return d.plus(u, m).square().minus(r.square()).sign();
    }

    /** t = (d.d - r^2) / (-u.d + sqrt((u.u) r^2 - cross(u, d)^2)): all terms positive. */
    public Dyadic time(int bits) {
      Dyadic below = dot(u, d).negate().plus(discriminant().sqrt(bits));
      return gap().over(below, bits);
    }

    /** t = (-u.d - sqrt((u.u) r^2 - cross(u, d)^2)) / u.u, of disks that are apart. */
    public ExactTime exactTime() {
      return new ExactTime(drift().negate(), discriminant(), u.square());
    }

    /** u.d */
    public Dyadic drift() {
      return dot(u, d);
    }

    /** d.d - r^2 */
    public Dyadic gap() {
      return d.square().minus(r.square());
    }

    /** (u.u) r^2 - |cross(u, d)|^2 = (u.d)^2 - (u.u) (d.d - r^2), which holds in space, too. */
    public Dyadic discriminant() {
      return drift().square().minus(u.square().times(gap()));
    }

    /**
     * The correctly rounded time of impact of disks that are apart and will touch, {@code
     * +infinity} if that is later than the window's end T.
     */
    public double time(double T) {
      PrecisionCounters.exactTime();
      double t = time();
      return t < T || T == Double.POSITIVE_INFINITY || (t == T && compareTime(Dyadic.of(T)) <= 0)
          ? t
          : Double.POSITIVE_INFINITY;
    }

    /** The correctly rounded time of impact of disks that are apart and will touch. */
    public double time() {
      Dyadic t = time(BITS);
      double low = t.floor();
      return nearer(low, compareTime(middle(low)));
    }

    /** The unit normal at a contact to come: (d + u t) / |d + u t|, or -u / |u| for two points. */
    public UnitVector normal() {
      if (r.sign() == 0) {
        return new Vector(u.x.negate(), u.y.negate(), Dyadic.ZERO).unit();
      }
      int cancelled = Math.max(0, Math.max(d.magnitude(), r.magnitude()) - r.magnitude());
      return d.plus(u, time(BITS + cancelled)).unit();
    }
  }

  /** A moving disk against the side of a line: c = cross(w, d), cv = cross(w, v - u). */
  public record Side(Dyadic c, Dyadic cv, Dyadic scaledSquare) {

    /** The side for a line at rest. */
    public static Side of(
        double px, double py, double r, double vx, double vy, double ax, double ay, double bx,
        double by) {
      return of(px, py, r, vx, vy, ax, ay, bx, by, 0, 0);
    }

    /** The side for a line that moves with the velocity u. */
    public static Side of(
        double px, double py, double r, double vx, double vy, double ax, double ay, double bx,
        double by, double ux, double uy) {
      Vector w = vector(bx, by, ax, ay);
      Dyadic c = cross(w, vector(px, py, ax, ay));
      Dyadic cv = cross(w, vector(vx, vy, ux, uy));
      return new Side(c.abs(), cv.abs(), w.square().times(Dyadic.of(r).square()));
    }

    /** The sign of t - m for the time of impact t, where c - cv t = r |w|. */
    public int compareTime(Dyadic m) {
      return c.minus(cv.times(m)).signedSquare().minus(scaledSquare).sign();
    }

    /** t = (c - r |w|) / cv. */
    public ExactTime exactTime() {
      return new ExactTime(c, scaledSquare, cv);
    }

    /** t = (c^2 - r^2 w.w) / ((c + r |w|) cv): all terms positive. */
    public double time() {
      Dyadic below = c.plus(scaledSquare.sqrt(BITS)).times(cv);
      Dyadic t = c.square().minus(scaledSquare).over(below, BITS);
      double low = t.floor();
      return nearer(low, compareTime(middle(low)));
    }
  }

  /** The sign of t - m for a wall: gap - speed t = 0. */
  public static int compareWallTime(double p, double r, double v, double wall, double m) {
    return wallGap(p, r, v, wall).minus(Dyadic.of(v).abs().times(Dyadic.of(m))).sign();
  }

  /** The correctly rounded t = gap / |v| of a disk that is apart from a wall and approaches it. */
  public static double wallTime(double p, double r, double v, double wall) {
    Dyadic gap = wallGap(p, r, v, wall);
    Dyadic speed = Dyadic.of(v).abs();
    Dyadic t = gap.over(speed, BITS);
    double low = t.floor();
    return nearer(low, gap.minus(speed.times(middle(low))).sign());
  }

  /** |p - wall| - r on the side from which a disk with velocity v comes. */
  public static Dyadic wallGap(double p, double r, double v, double wall) {
    Dyadic s = v < 0 ? Dyadic.difference(p, wall) : Dyadic.difference(wall, p);
    return s.minus(Dyadic.of(r));
  }

  /** (a - b) / |a - b|. */
  public static UnitVector unit(double ax, double ay, double bx, double by) {
    return vector(ax, ay, bx, by).unit();
  }

  /** (x, y) / |(x, y)|. */
  static UnitVector unit(Dyadic x, Dyadic y) {
    return new Vector(x, y, Dyadic.ZERO).unit();
  }

  /**
   * The double nearest to a time t, low or its upper neighbour; a tie goes to the even one. Low is
   * the largest double at or below an approximation of t to 120 bits, so t is at most that little
   * below it.
   *
   * @param sign that of t less the middle between the neighbours
   */
  private static double nearer(double low, int sign) {
    boolean even = (Double.doubleToRawLongBits(low) & 1) == 0;
    return sign < 0 || (sign == 0 && even) ? low : Math.nextUp(low);
  }

  /** Halfway between a double at or above 0 and its upper neighbour, 2^1024 for the largest. */
  private static Dyadic middle(double low) {
    return Dyadic.of(low).plus(Dyadic.of(Math.ulp(low)).half());
  }

  private static Dyadic sum(double r, double s) {
    return Dyadic.of(r).plus(Dyadic.of(s));
  }

  private static Vector vector(double ax, double ay, double bx, double by) {
    return new Vector(Dyadic.difference(ax, bx), Dyadic.difference(ay, by), Dyadic.ZERO);
  }

  private static Dyadic cross(Vector a, Vector b) {
    return a.x.times(b.y).minus(a.y.times(b.x));
  }

  private static Dyadic dot(Vector a, Vector b) {
    return a.x.times(b.x).plus(a.y.times(b.y)).plus(a.z.times(b.z));
  }

  /** A vector of exact numbers; z is 0 in the plane. */
  private record Vector(Dyadic x, Dyadic y, Dyadic z) {

    Dyadic square() {
      return x.square().plus(y.square()).plus(z.square());
    }

    Vector plus(Vector v, Dyadic t) {
      return new Vector(x.plus(v.x.times(t)), y.plus(v.y.times(t)), z.plus(v.z.times(t)));
    }

    Vector above(Dyadic height) {
      return new Vector(x, y, height);
    }

    int magnitude() {
      return square().sign() == 0 ? 0 : square().magnitude() / 2 + 1;
    }

    /** The unit vector of a vector in the plane. */
    UnitVector unit() {
      Dyadic length = square().sqrt(BITS);
      return new UnitVector(quotient(x, length), quotient(y, length));
    }

    private static double quotient(Dyadic a, Dyadic length) {
      return a.sign() == 0 ? 0 : a.sign() * a.abs().over(length, BITS).floor();
    }
  }
}
