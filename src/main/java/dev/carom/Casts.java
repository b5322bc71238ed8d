// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Optional;

/** The friendly form of the detector: from records to the record of an impact. */
final class Casts {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private Casts() {}

  static Optional<Impact> line(Circle circle, Vec2 v, Line line, double T) {
    int contact =
        SegmentSweep.contact(
            circle.x(),
            circle.y(),
            circle.radius(),
            v.x(),
            v.y(),
            line.ax(),
            line.ay(),
            line.bx(),
            line.by());
    double t =
        SegmentSweep.time(
            contact,
            circle.x(),
            circle.y(),
            circle.radius(),
            v.x(),
            v.y(),
            line.ax(),
            line.ay(),
            line.bx(),
            line.by(),
            T);
    return t == NEVER ? Optional.empty() : Optional.of(line(circle, v, line, contact, t));
  }

  /** The impact with a line, of which the detector told the contact and the time. */
  static Impact line(Circle circle, Vec2 v, Line line, int contact, double t) {
    return switch (contact & ~Contact.NOW) {
      case Contact.START -> end(circle, v, line.start(), line.end(), t, line, Feature.START);
      case Contact.END -> end(circle, v, line.end(), line.start(), t, line, Feature.END);
      case Contact.LEFT -> side(1, circle, v, line, t);
      default -> side(-1, circle, v, line, t);
    };
  }

  private static Impact end(
      Circle circle, Vec2 v, Endpoint end, Endpoint other, double t, Line line, Feature feature) {
    Vec2 normal =
        slides(circle, v, end, other, t)
            ? slideNormal(v, end, other)
            : vector(
                DiskSweep.normal(
                    circle.x(),
                    circle.y(),
                    circle.radius(),
                    v.x(),
                    v.y(),
                    end.x(),
                    end.y(),
                    0,
                    0,
                    0,
                    t));
    Vec2 point = new Vec2(end.x(), end.y());
    return impact(t, v, line, feature, point, normal);
  }

  /** Whether a point particle comes to an end over the line's side, not from beyond the end. */
  private static boolean slides(Circle circle, Vec2 v, Endpoint end, Endpoint other, double t) {
    return circle.radius() == 0
        && t > 0
        && Predicates.dot(v.x(), v.y(), 0, 0, other.x(), other.y(), end.x(), end.y()) < 0;
  }

  /** The side's normal, against the velocity: the limit of the normals from before. */
  private static Vec2 slideNormal(Vec2 v, Endpoint end, Endpoint other) {
    int drift = Predicates.cross(other.x(), other.y(), end.x(), end.y(), v.x(), v.y(), 0, 0);
    return vector(Directions.normal(-drift, end.x(), end.y(), other.x(), other.y()));
  }

  private static Impact side(int side, Circle circle, Vec2 v, Line line, double t) {
    Vec2 normal = vector(Directions.normal(side, line.ax(), line.ay(), line.bx(), line.by()));
    Vec2 point = line.closestPoint(place(circle, v, t));
    return impact(t, v, line, Feature.SIDE, point, normal);
  }

  private static Impact impact(
      double t, Vec2 v, Line line, Feature feature, Vec2 point, Vec2 normal) {
    double speed = approach(v, Vec2.ZERO, normal);
    return new Impact(t, ObstacleKind.LINE, Impact.NO_ID, line, feature, point, normal, speed);
  }

  static Optional<Impact> bounds(Circle circle, Vec2 v, Bounds bounds, double T) {
    double wallX = v.x() < 0 ? bounds.xmin() : bounds.xmax();
    double wallY = v.y() < 0 ? bounds.ymin() : bounds.ymax();
    double tx = WallSweep.time(circle.x(), circle.radius(), v.x(), wallX, T);
    double ty = WallSweep.time(circle.y(), circle.radius(), v.y(), wallY, T);
    if (tx == NEVER && ty == NEVER) {
      return Optional.empty();
    }
    boolean vertical = tx < ty || (tx == ty && !isEarlierInY(circle, v, wallX, wallY));
    int id =
        vertical
            ? (v.x() < 0 ? WallSweep.LEFT : WallSweep.RIGHT)
            : (v.y() < 0 ? WallSweep.BOTTOM : WallSweep.TOP);
    return Optional.of(wall(circle, v, bounds, id, Math.min(tx, ty)));
  }

  /** Of two walls whose rounded times are equal: whether the horizontal one is exactly earlier. */
  private static boolean isEarlierInY(Circle circle, Vec2 v, double wallX, double wallY) {
    ExactTime tx = WallSweep.exactTime(circle.x(), circle.radius(), v.x(), wallX);
    ExactTime ty = WallSweep.exactTime(circle.y(), circle.radius(), v.y(), wallY);
    return ty.compare(tx) < 0;
  }

  private static boolean isVertical(int wall) {
    return wall == WallSweep.LEFT || wall == WallSweep.RIGHT;
  }

  private static double coordinate(Bounds bounds, int wall) {
    return switch (wall) {
      case WallSweep.LEFT -> bounds.xmin();
      case WallSweep.RIGHT -> bounds.xmax();
      case WallSweep.BOTTOM -> bounds.ymin();
      default -> bounds.ymax();
    };
  }

  /** The impact with the wall that has the given id, of which the detector told the time. */
  static Impact wall(Circle circle, Vec2 v, Bounds bounds, int id, double t) {
    double wall = coordinate(bounds, id);
    Vec2 centre = place(circle, v, t);
    boolean vertical = isVertical(id);
    double speed = vertical ? v.x() : v.y();
    int away = speed < 0 ? 1 : -1;
    return new Impact(
        t,
        ObstacleKind.WALL,
        id,
        bounds,
        Feature.SIDE,
        vertical ? new Vec2(wall, centre.y()) : new Vec2(centre.x(), wall),
        vertical ? new Vec2(away, 0) : new Vec2(0, away),
        Math.abs(speed));
  }

  /** Disk 1 against disk 2, which is reported as the given obstacle. */
  static Optional<Impact> disk(
      Circle c1, Vec2 v1, Circle c2, Vec2 v2, ObstacleKind kind, Obstacle obstacle, double T) {
    int contact =
        DiskSweep.contact(
            c1.x(),
            c1.y(),
            c1.radius(),
            v1.x(),
            v1.y(),
            c2.x(),
            c2.y(),
            c2.radius(),
            v2.x(),
            v2.y());
    double t =
        DiskSweep.time(
            contact,
            c1.x(),
            c1.y(),
            c1.radius(),
            v1.x(),
            v1.y(),
            c2.x(),
            c2.y(),
            c2.radius(),
            v2.x(),
            v2.y(),
            T);
    return t == NEVER
        ? Optional.empty()
        : Optional.of(disk(c1, v1, c2, v2, kind, obstacle, contact, t));
  }

  /** The contact of two moving circles, null for none whose rounded time is at most a limit. */
  static Candidate candidate(Circle c1, Vec2 v1, Circle c2, Vec2 v2, double limit) {
    int contact =
        DiskSweep.contact(
            c1.x(), c1.y(), c1.radius(), v1.x(), v1.y(), c2.x(), c2.y(), c2.radius(), v2.x(),
            v2.y());
    // What rounds to the limit is exactly before the next double.
    double t =
        DiskSweep.time(
            contact, c1.x(), c1.y(), c1.radius(), v1.x(), v1.y(), c2.x(), c2.y(), c2.radius(),
            v2.x(), v2.y(), Math.nextUp(limit));
    if (t > limit || t == NEVER) {
      return null;
    }
    return new Candidate(
        t,
        () ->
            DiskSweep.exactTime(
                contact, c1.x(), c1.y(), c1.radius(), v1.x(), v1.y(), c2.x(), c2.y(),
                c2.radius(), v2.x(), v2.y()),
        () -> disk(c1, v1, c2, v2, ObstacleKind.CIRCLE, c2, contact, t));
  }

  /** The impact of two disks, of which the detector told the contact and the time. */
  static Impact disk(
      Circle c1,
      Vec2 v1,
      Circle c2,
      Vec2 v2,
      ObstacleKind kind,
      Obstacle obstacle,
      int contact,
      double t) {
    Vec2 normal =
        vector(
            DiskSweep.normal(
                c1.x(),
                c1.y(),
                c1.radius(),
                v1.x(),
                v1.y(),
                c2.x(),
                c2.y(),
                c2.radius(),
                v2.x(),
                v2.y(),
                t));
    Vec2 point = contact == Contact.NOW ? between(c1, c2) : rim(c2, v2, t, normal);
    double speed = approach(v1, v2, normal);
    return new Impact(t, kind, Impact.NO_ID, obstacle, Feature.CIRCLE, point, normal, speed);
  }

  /** A peg; an endpoint is one of radius 0. */
  static Circle peg(Obstacle obstacle) {
    return obstacle instanceof Endpoint end ? new Circle(end.x(), end.y(), 0) : (Circle) obstacle;
  }

  private static Vec2 vector(UnitVector n) {
    return new Vec2(n.x(), n.y());
  }

  /** Where two that overlap or touch meet: their distance is divided as their radii. */
  private static Vec2 between(Circle c1, Circle c2) {
    double share = ObstacleResponse.share(c2.radius(), c1.radius());
    return new Vec2(Coordinates.between(share, c2.x(), c1.x()), Coordinates.between(share, c2.y(), c1.y()));
  }

  private static Vec2 rim(Circle circle, Vec2 v, double t, Vec2 normal) {
    Vec2 centre = place(circle, v, t);
    return Vec2.within(
        Math.fma(circle.radius(), normal.x(), centre.x()),
        Math.fma(circle.radius(), normal.y(), centre.y()));
  }

  private static Vec2 place(Circle circle, Vec2 v, double t) {
    return Vec2.within(Math.fma(v.x(), t, circle.x()), Math.fma(v.y(), t, circle.y()));
  }

  /** The speed along the normal at which the distance falls: -(v1 - v2).n; it may be infinite. */
  private static double approach(Vec2 v1, Vec2 v2, Vec2 n) {
    double speed = -((v1.x() - v2.x()) * n.x() + (v1.y() - v2.y()) * n.y());
    if (!(Math.abs(speed) <= Double.MAX_VALUE)) {
      double ux = v1.x() / 4 - v2.x() / 4;
      double uy = v1.y() / 4 - v2.y() / 4;
      speed = 4 * -(ux * n.x() + uy * n.y());
    }
    return Math.max(0, speed);
  }
}
