// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import static dev.carom.bench.methods.RealDouble.real;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;

/**
 * The lines in double, as the published algorithm meets them. With u the unit vector of a line, a
 * point has the coordinates {@code along = u.(p - a)} and {@code off = u x (p - a)}: the line lies
 * on off = 0 from along = 0 to its length, and the first point of it that is nearest to p is the
 * one at along, held within 0..length.
 */
final class PosterLines {

  final int count;
  final double[] restitution;

  /** Counted here, where they are taken. */
  int squareRoots;

  private final double[] ax;
  private final double[] ay;
  private final double[] ux;
  private final double[] uy;
  private final double[] length;

  /** 0 for a line, the radius of a peg. */
  private final double[] thickness;

  PosterLines(Scene scene) {
    this(scene.count(Kind.LINE) + scene.count(Kind.PEG));
    int straight = scene.count(Kind.LINE);
    for (int k = 0; k < straight; k++) {
      setLine(k, (Line) scene.shape(Kind.LINE, k), real(scene.traits(Kind.LINE, k).restitution()));
    }
    for (int k = straight; k < count; k++) {
      Circle peg = (Circle) scene.shape(Kind.PEG, k - straight);
      setLine(
          k,
          new Line(peg.x(), peg.y(), peg.x(), peg.y()),
          real(scene.traits(Kind.PEG, k - straight).restitution()));
      thickness[k] = real(peg.radius());
    }
  }

  /** Room for lines that are yet to be set. */
  PosterLines(int count) {
    this.count = count;
    restitution = new double[count];
    ax = new double[count];
    ay = new double[count];
    ux = new double[count];
    uy = new double[count];
    length = new double[count];
    thickness = new double[count];
  }

  void setLine(int k, Line line, double e) {
    Vec2 direction = PlainScene.direction(line);
    ax[k] = real(line.ax());
    ay[k] = real(line.ay());
    ux[k] = real(direction.x());
    uy[k] = real(direction.y());
    length[k] = real(line.length());
    restitution[k] = e;
  }

  /**
   * The four questions of the publication about the motion v of this frame, one yes of which makes
   * the line a candidate: does the motion cross the line; does it end within the radius of the
   * line's closest point; does it pass the start, or the end, within the radius?
   */
  boolean candidate(int k, double px, double py, double vx, double vy, double r) {
    double l = length[k];
    double reach = r + thickness[k];
    double ex = px - ax[k];
    double ey = py - ay[k];
    double along = ux[k] * ex + uy[k] * ey;
    double off = ux[k] * ey - uy[k] * ex;
    double vAlong = ux[k] * vx + uy[k] * vy;
    double vOff = ux[k] * vy - uy[k] * vx;
    double alongEnd = along + vAlong;
    double offEnd = off + vOff;
    double beyond = alongEnd - Math.max(0, Math.min(l, alongEnd));
    return beyond * beyond + offEnd * offEnd < reach * reach
        || passes(along, off, vAlong, vOff, reach)
        || passes(along - l, off, vAlong, vOff, reach)
        || crosses(along, off, alongEnd, offEnd, l);
  }

  /** Whether the foot of the origin lies on the motion v from e, and nearer than the reach. */
  private static boolean passes(double ex, double ey, double vx, double vy, double reach) {
    double ahead = -(ex * vx + ey * vy);
    double vv = vx * vx + vy * vy;
    double cross = ex * vy - ey * vx;
    return ahead >= 0 && ahead <= vv && cross * cross < reach * reach * vv;
  }

  /** Whether off changes its sign on the way, at an along within 0..l. */
  private static boolean crosses(
      double along, double off, double alongEnd, double offEnd, double l) {
    if (off * offEnd > 0 || off == offEnd) {
      return false;
    }
    double at = (along * offEnd - alongEnd * off) / (offEnd - off);
    return at >= 0 && at <= l;
  }

  /**
   * The fraction of the motion v at which the circle touches the line: where it touches the
   * infinite line, if its centre is over the line then; else where it touches the end in whose
   * Voronoi region it is. 0 if it overlaps and comes nearer; infinite if it does not come nearer.
   */
  double contact(int k, double px, double py, double vx, double vy, double r) {
    double reach = r + thickness[k];
    double ex = px - ax[k];
    double ey = py - ay[k];
    double along = ux[k] * ex + uy[k] * ey;
    double off = ux[k] * ey - uy[k] * ex;
    double vAlong = ux[k] * vx + uy[k] * vy;
    double approach = (off > 0 ? -1 : 1) * (ux[k] * vy - uy[k] * vx);
    double gap = Math.max(0, Math.abs(off) - reach);
    if (gap > 0 && !(approach > 0)) {
      return Double.POSITIVE_INFINITY;
    }
    double t = gap > 0 ? gap / approach : 0;
    double at = along + t * vAlong;
    if (at > 0 && at < length[k]) {
      return approach > 0 ? t : Double.POSITIVE_INFINITY;
    }
    double end = at > 0 ? length[k] : 0;
    return pointContact(ex - end * ux[k], ey - end * uy[k], vx, vy, reach);
  }

  /** The smaller root of v.v t^2 + 2 e.v t + e.e - r^2 = 0: c / (-b + sqrt(b^2 - a c)). */
  private double pointContact(double ex, double ey, double vx, double vy, double reach) {
    double b = ex * vx + ey * vy;
    if (!(b < 0)) {
      return Double.POSITIVE_INFINITY;
    }
    double c = ex * ex + ey * ey - reach * reach;
    if (c <= 0) {
      return 0;
    }
    double vv = vx * vx + vy * vy;
    double cross = ex * vy - ey * vx;
    double discriminant = vv * (reach * reach) - cross * cross;
    if (discriminant < 0) {
      return Double.POSITIVE_INFINITY;
    }
    squareRoots++;
    return c / (real(Math.sqrt(discriminant)) - b);
  }

  /**
   * The x component from the line's closest point to c, or, over the line, of its perpendicular.
   */
  double normalX(int k, double cx, double cy) {
    double along = along(k, cx, cy);
    return along > 0 && along < length[k] ? -uy[k] : cx - ax[k] - end(k, along) * ux[k];
  }

  /** The y component of the same normal. */
  double normalY(int k, double cx, double cy) {
    double along = along(k, cx, cy);
    return along > 0 && along < length[k] ? ux[k] : cy - ay[k] - end(k, along) * uy[k];
  }

  private double along(int k, double cx, double cy) {
    return ux[k] * (cx - ax[k]) + uy[k] * (cy - ay[k]);
  }

  private double end(int k, double along) {
    return along > 0 ? length[k] : 0;
  }
}
