// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.OutlinePoints;
import dev.carom.internal.util.Check;
import java.util.ArrayList;
import java.util.List;

/**
 * An {@code Outline} is joined lines that are one thing: a polyline or a solid polygon. A bucket
 * and the ground are polylines, a brick and a racket are polygons. In a scene it has one id, of the
 * kind {@link Kind#LINE}; it is moved and removed as one, and an {@link Impact} names the {@link
 * Impact#part side} that was hit.
 *
 * <p>A polyline has no inside: circles bounce off both of its sides. A hollow loop is a polyline
 * that ends where it begins. A solid polygon keeps circles out. A circle whose centre is inside,
 * since it was put there or pressed on a wall, may leave: nothing of the polygon stops it until its
 * centre is outside.
 *
 * <pre>{@code
 * Scene scene =
 *     Scene.builder().outline(Outline.rectangle(4, 0, 6, 4)).circle(1, 1, 1, 1, 0).build();
 * World world = new World(scene);
 * world.advanceTo(3);
 * Impact hit = world.impacts().get(0);
 * System.out.println(hit.kind() + " " + hit.id() + ", side " + hit.part()); // LINE 0, side 3
 * }</pre>
 *
 * @param points the vertices in their order, at least two; at least three if it is solid. No two
 *     that follow each other are equal
 * @param solid whether it is a solid polygon: then a last side leads from the last vertex to the
 *     first. Either direction around it will do
 */
public record Outline(List<Vec2> points, boolean solid) implements Obstacle {

  /**
   * Copies and checks the points.
   *
   * @param points the vertices
   * @param solid whether it is a solid polygon
   * @throws IllegalArgumentException if there are too few points; if two that follow each other are
   *     equal, as the last and the first of a solid polygon do; or if a solid polygon crosses or
   *     touches itself
   */
  public Outline {
    points = copy(points);
    values(points, solid).check();
  }

  private static List<Vec2> copy(List<Vec2> points) {
    List<Vec2> copy = new ArrayList<>();
    for (Vec2 point : Check.notNull("points", points)) {
      copy.add(Check.notNull("points[" + copy.size() + "]", point));
    }
    return List.copyOf(copy);
  }

  /**
   * Makes a polyline.
   *
   * @param xy x, y, x, y, ... of its points, finite
   * @return the outline
   * @throws IllegalArgumentException if a coordinate is NaN or infinite, if their number is odd, or
   *     for what the constructor refuses
   */
  public static Outline polyline(double... xy) {
    return new Outline(points(xy), false);
  }

  /**
   * Makes a solid polygon.
   *
   * @param xy x, y, x, y, ... of its vertices, finite
   * @return the outline
   * @throws IllegalArgumentException if a coordinate is NaN or infinite, if their number is odd, or
   *     for what the constructor refuses
   */
  public static Outline polygon(double... xy) {
    return new Outline(points(xy), true);
  }

  /**
   * Makes a solid rectangle. Its sides are numbered from the bottom on: bottom 0, right 1, top 2,
   * left 3, if y points up.
   *
   * @param xmin the x coordinate of its left side, finite
   * @param ymin the y coordinate of its bottom side, finite
   * @param xmax the x coordinate of its right side, finite and greater than xmin
   * @param ymax the y coordinate of its top side, finite and greater than ymin
   * @return the outline
   * @throws IllegalArgumentException if a coordinate is NaN or infinite, or not greater
   */
  public static Outline rectangle(double xmin, double ymin, double xmax, double ymax) {
    Check.finite("xmin", xmin);
    Check.finite("ymin", ymin);
    Check.finite("xmax", xmax);
    Check.finite("ymax", ymax);
    Check.bounds(xmin, ymin, xmax, ymax);
    return polygon(xmin, ymin, xmax, ymin, xmax, ymax, xmin, ymax);
  }

  private static List<Vec2> points(double... xy) {
    if (Check.notNull("xy", xy).length % 2 != 0) {
      throw Check.refused("xy", xy.length + " numbers", "an even number of them: x, y, x, y, ...");
    }
    List<Vec2> points = new ArrayList<>();
    for (int k = 0; k < xy.length; k += 2) {
      Check.finite("xy[" + k + "]", xy[k]);
      Check.finite("xy[" + (k + 1) + "]", xy[k + 1]);
      points.add(new Vec2(xy[k], xy[k + 1]));
    }
    return points;
  }

  /**
   * Returns the number of sides.
   *
   * @return one for each point; of a polyline one less
   */
  int sides() {
    return values().sides();
  }

  /**
   * Returns side i, from point i to the next one.
   *
   * @param i its number, from 0 on: of a solid polygon to the number of points less 1, of a
   *     polyline less 2
   * @return the side
   * @throws IndexOutOfBoundsException if there is no such side
   */
  public Line side(int i) {
    if (i < 0 || i >= sides()) {
      throw new IndexOutOfBoundsException("side is " + i + ": expected 0 to " + (sides() - 1));
    }
    return new Line(points.get(i), points.get((i + 1) % points.size()));
  }

  OutlinePoints values() {
    return values(points, solid);
  }

  private static OutlinePoints values(List<Vec2> points, boolean solid) {
    double[] xy = new double[2 * points.size()];
    for (int i = 0; i < points.size(); i++) {
      xy[2 * i] = points.get(i).x();
      xy[2 * i + 1] = points.get(i).y();
    }
    return new OutlinePoints(xy, solid);
  }
}
