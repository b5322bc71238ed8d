// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.query.Region;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.OutlinePoints;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.PegShape;
import dev.carom.internal.util.Check;
import java.util.ArrayList;
import java.util.List;

/** Makes public records of the rows of {@link ObstacleTable}. */
final class PublicRecords {

  private PublicRecords() {}

  /** A line, or a peg, as it is at a time; of a wall, the bounds. */
  static Obstacle of(ObstacleTable obstacles, int code, double now) {
    if (Codes.isWall(code)) {
      return bounds(obstacles.walls);
    }
    return Codes.isLine(code) ? lines(obstacles, code, now) : peg(obstacles, code, now);
  }

  /** A line, or an outline, of which the code of the first side is given, as it is at a time. */
  private static Obstacle lines(ObstacleTable obstacles, int code, double now) {
    double[][] rows = new double[obstacles.endOf(code) - code][];
    for (int i = 0; i < rows.length; i++) {
      rows[i] = obstacles.rowAt(code + i, now, 0);
    }
    return lines(rows, obstacles.outside(code) != 0);
  }

  /** A line, or an outline, by the rows of its sides. */
  static Obstacle lines(double[][] rows, boolean isSolid) {
    return rows.length == 1 ? line(rows[0], 0) : outline(OutlinePoints.of(rows, isSolid));
  }

  /** An outline; its first side if it is so far away that its points round to others. */
  private static Obstacle outline(OutlinePoints outline) {
    if (!outline.isOne()) {
      return line(outline.side(0), 0);
    }
    List<Vec2> points = new ArrayList<>();
    for (int i = 0; i < outline.count(); i++) {
      points.add(new Vec2(outline.x(i), outline.y(i)));
    }
    return new Outline(points, outline.isSolid());
  }

  static Line line(ObstacleTable obstacles, int code, double now) {
    return line(obstacles.rowAt(code, now, 0), 0);
  }

  static Circle peg(ObstacleTable obstacles, int code, double now) {
    return peg(obstacles.rowAt(code, now, 0), 0);
  }

  /** The bounds with these walls; null for null. */
  static Bounds bounds(double[] walls) {
    return walls == null
        ? null
        : new Bounds(walls[Codes.LEFT], walls[Codes.BOTTOM], walls[Codes.RIGHT], walls[Codes.TOP]);
  }

  /** Returns the words that messages use for the bounds with these walls, which may be null. */
  static String describe(double[] walls) {
    return walls == null ? "none" : bounds(walls).toString();
  }

  static Region region(Circle disk) {
    Check.notNull("disk", disk);
    return Region.disk(disk.x(), disk.y(), disk.radius());
  }

  static Region region(Bounds box) {
    return Region.box(walls(Check.notNull("box", box)));
  }

  /** Returns the places of the walls of bounds, by their codes. */
  static double[] walls(Bounds b) {
    return ObstacleTable.walls(b.xmin(), b.ymin(), b.xmax(), b.ymax());
  }

  /** The line whose row begins at a place in an array. */
  static Line line(double[] rows, int k) {
    return new Line(
        rows[k + LineShape.AX],
        rows[k + LineShape.AY],
        rows[k + LineShape.BX],
        rows[k + LineShape.BY]);
  }

  /** The peg whose row begins at a place in an array. */
  static Circle peg(double[] rows, int k) {
    return new Circle(rows[k + PegShape.X], rows[k + PegShape.Y], rows[k + PegShape.RADIUS]);
  }
}
