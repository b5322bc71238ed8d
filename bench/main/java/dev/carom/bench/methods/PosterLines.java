// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.ObstacleKind;
import dev.carom.Scene;

/**
 * The lines in float, as the published algorithm meets them. With u the unit vector of a line, a
 * point has the coordinates {@code along = u.(p - a)} and {@code off = u x (p - a)}: the line lies
 * on off = 0 from along = 0 to its length, and the first point of it that is nearest to p is the
 * one at along, held within 0..length.
 */
final class PosterLines {

  final int count;
  final float[] restitution;

  /** Counted here, where they are taken. */
  int squareRoots;

  private final float[] ax;
  private final float[] ay;
  private final float[] ux;
  private final float[] uy;
  private final float[] length;

  /** 0 for a line, the radius of a peg. */
  private final float[] thickness;

  PosterLines(Scene scene) {
    this(scene.lineCount() + scene.pegCount());
    int straight = scene.lineCount();
    for (int k = 0; k < straight; k++) {
      setLine(k, scene.line(k), scene.restitution(ObstacleKind.LINE, k));
    }
    for (int k = straight; k < count; k++) {
      Circle peg = scene.peg(k - straight);
      setLine(
          k,
          new Line(peg.x(), peg.y(), peg.x(), peg.y()),
          scene.restitution(ObstacleKind.PEG, k - straight));
      thickness[k] = (float) peg.radius();
    }
  }

  /** Room for lines that are yet to be set. */
  PosterLines(int count) {
    this.count = count;
    restitution = new float[count];
    ax = new float[count];
    ay = new float[count];
    ux = new float[count];
    uy = new float[count];
    length = new float[count];
    thickness = new float[count];
  }

  void setLine(int k, Line line, double e) {
    double l = line.length();
    ax[k] = (float) line.ax();
    ay[k] = (float) line.ay();
    ux[k] = l > 0 ? (float) ((line.bx() - line.ax()) / l) : 1;
    uy[k] = l > 0 ? (float) ((line.by() - line.ay()) / l) : 0;
    length[k] = (float) l;
    restitution[k] = (float) e;
  }

  /**
   * The four questions of the publication about the motion v of this frame, one yes of which makes
   * the line a candidate: does the motion cross the line; does it end within the radius of the
   * line's closest point; does it pass the start, or the end, within the radius?
   */
  boolean candidate(int k, float px, float py, float vx, float vy, float r) {
    float l = length[k];
    float reach = r + thickness[k];
    float ex = px - ax[k];
    float ey = py - ay[k];
    float along = ux[k] * ex + uy[k] * ey;
    float off = ux[k] * ey - uy[k] * ex;
    float vAlong = ux[k] * vx + uy[k] * vy;
    float vOff = ux[k] * vy - uy[k] * vx;
    float alongEnd = along + vAlong;
    float offEnd = off + vOff;
    float beyond = alongEnd - Math.max(0, Math.min(l, alongEnd));
    return beyond * beyond + offEnd * offEnd < reach * reach
        || passes(along, off, vAlong, vOff, reach)
        || passes(along - l, off, vAlong, vOff, reach)
        || crosses(along, off, alongEnd, offEnd, l);
  }

  /** Whether the foot of the origin lies on the motion v from e, and nearer than the reach. */
  private static boolean passes(float ex, float ey, float vx, float vy, float reach) {
    float ahead = -(ex * vx + ey * vy);
    float vv = vx * vx + vy * vy;
    float cross = ex * vy - ey * vx;
    return ahead >= 0 && ahead <= vv && cross * cross < reach * reach * vv;
  }

  /** Whether off changes its sign on the way, at an along within 0..l. */
  private static boolean crosses(float along, float off, float alongEnd, float offEnd, float l) {
    if (off * offEnd > 0 || off == offEnd) {
      return false;
    }
    float at = (along * offEnd - alongEnd * off) / (offEnd - off);
    return at >= 0 && at <= l;
  }

  /**
   * The fraction of the motion v at which the circle touches the line: where it touches the
   * infinite line, if its centre is over the line then; else where it touches the end in whose
   * Voronoi region it is. 0 if it overlaps and comes nearer; infinite if it does not come nearer.
   */
  float contact(int k, float px, float py, float vx, float vy, float r) {
    float reach = r + thickness[k];
    float ex = px - ax[k];
    float ey = py - ay[k];
    float along = ux[k] * ex + uy[k] * ey;
    float off = ux[k] * ey - uy[k] * ex;
    float vAlong = ux[k] * vx + uy[k] * vy;
    float approach = (off > 0 ? -1 : 1) * (ux[k] * vy - uy[k] * vx);
    float gap = Math.max(0, Math.abs(off) - reach);
    if (gap > 0 && !(approach > 0)) {
      return Float.POSITIVE_INFINITY;
    }
    float t = gap > 0 ? gap / approach : 0;
    float at = along + t * vAlong;
    if (at > 0 && at < length[k]) {
      return approach > 0 ? t : Float.POSITIVE_INFINITY;
    }
    float end = at > 0 ? length[k] : 0;
    return pointContact(ex - end * ux[k], ey - end * uy[k], vx, vy, reach);
  }

  /** The smaller root of v.v t^2 + 2 e.v t + e.e - r^2 = 0: c / (-b + sqrt(b^2 - a c)). */
  private float pointContact(float ex, float ey, float vx, float vy, float reach) {
    float b = ex * vx + ey * vy;
    if (!(b < 0)) {
      return Float.POSITIVE_INFINITY;
    }
    float c = ex * ex + ey * ey - reach * reach;
    if (c <= 0) {
      return 0;
    }
    float vv = vx * vx + vy * vy;
    float cross = ex * vy - ey * vx;
    float discriminant = vv * (reach * reach) - cross * cross;
    if (discriminant < 0) {
      return Float.POSITIVE_INFINITY;
    }
    squareRoots++;
    return c / ((float) Math.sqrt(discriminant) - b);
  }

  /**
   * The x component from the line's closest point to c, or, over the line, of its perpendicular.
   */
  float normalX(int k, float cx, float cy) {
    float along = along(k, cx, cy);
    return along > 0 && along < length[k] ? -uy[k] : cx - ax[k] - end(k, along) * ux[k];
  }

  /** The y component of the same normal. */
  float normalY(int k, float cx, float cy) {
    float along = along(k, cx, cy);
    return along > 0 && along < length[k] ? ux[k] : cy - ay[k] - end(k, along) * uy[k];
  }

  private float along(int k, float cx, float cy) {
    return ux[k] * (cx - ax[k]) + uy[k] * (cy - ay[k]);
  }

  private float end(int k, float along) {
    return along > 0 ? length[k] : 0;
  }
}
