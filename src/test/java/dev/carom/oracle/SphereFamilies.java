// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.List;

/** Queries about two spheres, of the kinds of {@link PairFamilies}, in all three dimensions. */
public final class SphereFamilies {
  private static final double[] NONE = {0, 0, 0};

  public static final List<String> NAMES =
      List.of(
          "uniform",
          "near_graze",
          "exact_graze",
          "touching",
          "overlapping",
          "concentric",
          "same_velocity",
          "fast",
          "far",
          "tiny_or_huge",
          "size_ratio",
          "window_end",
          "end_after_a_long_way",
          "lattice",
          "extreme",
          "brink_across",
          "brink_units");

  private SphereFamilies() {}

  /** The next query of a family. */
  public static SphereQuery next(String family, Draw d) {
    double[] n =
        switch (family) {
          case "near_graze" -> nudged(d, aimed(d, Math.PI / 2 - tiny(d), d.log(0.5, 400), 1));
          case "exact_graze" -> exactGraze(d);
          case "touching" -> nudged(d, aimed(d, d.in(0, 3), d.log(0.5, 400), 0));
          case "overlapping" -> query(d, scaled(direction(d), d.in(0, 20)), velocity(d), 20);
          case "concentric" -> nudged(d, query(d, NONE, velocity(d), d.in(0, 40)));
          case "same_velocity" -> nudged(d, query(d, place(d), NONE, d.in(0, 40)));
          case "fast" -> aimed(d, d.in(0, 1.5), d.log(1e4, 1e11), 1);
          case "far" -> far(d);
          case "tiny_or_huge" -> scale(d, aimed(d, d.in(0, 1.5), 10, 1));
          case "size_ratio" -> sizeRatio(d);
          case "window_end" -> ended(d, d.chance(0.5) ? aimed(d, d.in(0, 1.5), 20, 1) : lattice(d));
          case "end_after_a_long_way" -> ended(d, longWay(d));
          case "lattice" -> lattice(d);
          case "extreme" -> extreme(d);
          case "brink_across" -> across(d);
          case "brink_units" -> units(d);
          default -> uniform(d);
        };
    if (d.chance(0.05)) {
      n[14] = Double.POSITIVE_INFINITY;
    }
    return new SphereQuery(n);
  }

  private static double tiny(Draw d) {
    return d.chance(0.5) ? 0 : d.sign() * d.log(1e-16, 1e-2);
  }

  private static double[] direction(Draw d) {
    double z = d.in(-1, 1);
    Draw.Point p = d.direction().times(Math.sqrt(1 - z * z));
    return new double[] {p.x(), p.y(), z};
  }

  private static double[] place(Draw d) {
    return new double[] {d.in(-100, 100), d.in(-100, 100), d.in(-100, 100)};
  }

  private static double[] velocity(Draw d) {
    return scaled(direction(d), d.log(0.5, 400));
  }

  private static double[] scaled(double[] v, double by) {
    return new double[] {v[0] * by, v[1] * by, v[2] * by};
  }

  private static double[] plus(double[] v, double[] w) {
    return new double[] {v[0] + w[0], v[1] + w[1], v[2] + w[2]};
  }

  /** Two spheres with given offset, relative velocity and sum of the radii. */
  private static double[] query(Draw d, double[] e, double[] u, double radius) {
    double[] at = place(d);
    double[] common = d.chance(0.4) ? NONE : place(d);
    double[] p = plus(at, e);
    double[] v = plus(common, u);
    double r1 = radius * d.pick(0, 0.5, 1, d.in(0, 1), d.in(0, 1));
    double r2 = Math.max(0, radius - r1);
    return new double[] {
      p[0], p[1], p[2], r1, v[0], v[1], v[2], at[0], at[1], at[2], r2, common[0], common[1],
      common[2], 1
    };
  }

  private static double[] uniform(Draw d) {
    return d.chance(0.5)
        ? aimed(d, d.in(0, 1.5), d.log(0.5, 400), 1)
        : query(d, place(d), velocity(d), d.in(0, 60));
  }

  /** They touch at a time of 0..far, at an angle between the normal and the velocity. */
  private static double[] aimed(Draw d, double angle, double speed, double far) {
    double radius = d.in(0.1, 40);
    double[] normal = direction(d);
    double[] u = scaled(turned(d, normal, angle), -speed);
    double time = far == 0 ? 0 : d.in(0.01, 0.99) * far;
    return query(d, plus(scaled(normal, radius), scaled(u, -time)), u, radius);
  }

  /** A unit vector at an angle to another. */
  private static double[] turned(Draw d, double[] normal, double angle) {
    double[] any = direction(d);
    double along = any[0] * normal[0] + any[1] * normal[1] + any[2] * normal[2];
    double[] across = plus(any, scaled(normal, -along));
    double length = Math.hypot(Math.hypot(across[0], across[1]), across[2]);
    return plus(
        scaled(normal, StrictMath.cos(angle)), scaled(across, StrictMath.sin(angle) / length));
  }

  private static double[] nudged(Draw d, double[] n) {
    d.nudgeOne(n, 0.7);
    n[3] = Math.abs(n[3]);
    n[10] = Math.abs(n[10]);
    return n;
  }

  /** Past the pole of a sphere: the offset (k, j, z), the velocity within the tangential plane. */
  private static double[] exactGraze(Draw d) {
    double r = d.whole(1, 1000);
    double j = d.whole(1, 60);
    double[] u = {-j * d.whole(1, 4), j, 0};
    double time = d.whole(1, 9);
    double[] e = {-u[0] * time, -u[1] * time, r};
    double[] n = {e[0] + 7, e[1], e[2] - 3, r, u[0], u[1] + 5, 1, 7, 0, -3, 0, 0, 5, 1, 1e9};
    return d.chance(0.5) ? nudged(d, permuted(n)) : permuted(n);
  }

  /** The axes one further. */
  static double[] permuted(double[] n) {
    double[] p = n.clone();
    for (int at : new int[] {0, 4, 7, 11}) {
      p[at] = n[at + 1];
      p[at + 1] = n[at + 2];
      p[at + 2] = n[at];
    }
    return p;
  }

  private static double[] far(Draw d) {
    double[] n = aimed(d, d.in(0, 1.5), d.log(0.5, 400), 1);
    for (int i = 0; i < 3; i++) {
      n[i] += 1e12;
      n[i + 7] += 1e12;
    }
    return n;
  }

  private static double[] scale(Draw d, double[] n) {
    Extremes.scale(n, (int) d.pick(d.whole(-60, -20), d.whole(20, 60)));
    return n;
  }

  private static double[] sizeRatio(Draw d) {
    double[] n = aimed(d, d.in(0, 1.5), d.log(0.5, 400), 1);
    double more = d.log(1e3, 1e13);
    n[10] += more;
    n[7] += n[7] > n[0] ? more : -more;
    return n;
  }

  /** The window ends at, or some ulps beside, the time of impact. */
  private static double[] ended(Draw d, double[] n) {
    n[14] = Double.POSITIVE_INFINITY;
    double t = new SphereQuery(n).truth();
    n[14] = Math.abs(Draw.ulps(Math.min(t, 1e300), d.whole(-2, 2)));
    return n;
  }

  /** Along one axis, from many radii away: there the other axes add little to what is rounded. */
  private static double[] longWay(Draw d) {
    double[] u = {-d.log(2, 1e4), 0, 0};
    double[] normal = turned(d, new double[] {1, 0, 0}, d.in(0, 1.2));
    double radius = d.in(0.5, 2);
    double[] way = scaled(u, -d.log(2, 1e4));
    double[] n = query(d, plus(scaled(normal, radius), way), u, radius);
    for (int turns = d.whole(0, 2); turns > 0; turns--) {
      n = permuted(n);
    }
    return n;
  }

  /** Overlapping spheres that move across the line between them as far as doubles can. */
  private static double[] across(Draw d) {
    double[] normal = direction(d);
    double[] u = scaled(turned(d, normal, Math.PI / 2), d.log(0.1, 10));
    return query(d, scaled(normal, d.log(0.1, 100)), u, 200);
  }

  /** Near grazes in units of length and of time so small or large that squares leave the range. */
  private static double[] units(Draw d) {
    double[] n = aimed(d, Math.PI / 2 - tiny(d), d.log(0.5, 400), 1);
    int speed = d.chance(0.3) ? 0 : d.whole(-900, 900);
    Extremes.scale(n, (int) d.pick(-d.whole(250, 280), -d.whole(500, 560), d.whole(100, 900)));
    for (int i : new int[] {4, 5, 6, 11, 12, 13}) {
      n[i] = clamped(Math.scalb(n[i], speed));
    }
    n[14] = Math.scalb(n[14], -speed);
    return n;
  }

  private static double clamped(double value) {
    return Math.max(-1e300, Math.min(value, 1e300));
  }

  private static double[] lattice(Draw d) {
    double[] n = new double[15];
    for (int i = 0; i < 14; i++) {
      n[i] = i == 3 || i == 10 ? d.whole(0, 3) : d.whole(-4, 4);
    }
    n[14] = d.whole(0, 3);
    return n;
  }

  private static double[] extreme(Draw d) {
    double[] n = d.chance(0.5) ? lattice(d) : uniform(d);
    switch (d.whole(0, 3)) {
      case 0 -> Extremes.scale(n, d.whole(-1060, 1000));
      case 1 -> Extremes.scaleTime(d, n, 4, 5, 6, 11, 12, 13);
      case 2 -> Extremes.mix(d, n);
      default -> n = Extremes.denormal(n);
    }
    n[3] = Math.abs(n[3]);
    n[10] = Math.abs(n[10]);
    for (int i = 0; i < 14; i++) {
      n[i] = clamped(n[i]);
    }
    return n;
  }
}
