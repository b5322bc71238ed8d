// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Kind;
import dev.carom.Timeline;
import dev.carom.bench.charts.Style;
import dev.carom.bench.duel.PlayedFrame;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.function.IntFunction;

/** The last places of circles, as lines that fade. */
final class Trails {

  /** With more circles a frame has no time to look where each trail turns. */
  private static final int MANY = 2_000;

  /** How often a piece of a trail that is not straight is halved. */
  private static final int HALVINGS = 5;

  /** In pixels: what bends by less is drawn as a straight line. */
  private static final double STRAIGHT = 0.4;

  private static final int SHADES = 8;
  private static final double BOLDEST = 0.8;

  /** Tells where a circle was. */
  @FunctionalInterface
  private interface Course {

    /**
     * Its place at a share of the trail's time; null if it was not there, or no trail began yet.
     */
    Point2D at(int circle, double share);
  }

  private final int circles;
  private final Course course;

  private Trails(int circles, Course course) {
    this.circles = circles;
    this.course = course;
  }

  /** Those of a recording: a trail turns where the circle did, and begins after the last jump. */
  static Trails of(Player player, double time) {
    Timeline past = player.past();
    double end = player.shown();
    double begin = Math.max(past.start(), end - time);
    return new Trails(
        player.circles(),
        (id, share) -> {
          double t = share == 1 ? end : begin + (end - begin) * share;
          return t < player.lastJump(id) || !past.contains(Kind.CIRCLE, id, t)
              ? null
              : place(past.x(id, t), past.y(id, t));
        });
  }

  /** Those of a duel: straight from frame to frame. */
  static Trails of(IntFunction<PlayedFrame> frames, int end, int length) {
    return new Trails(
        frames.apply(end).circles(),
        (i, share) -> {
          double at = end - length + share * length;
          int frame = (int) Math.floor(at);
          if (frame < 0) {
            return null;
          }
          PlayedFrame from = frames.apply(frame);
          PlayedFrame to = frames.apply(Math.min(end, frame + 1));
          double rest = at - frame;
          return place(
              from.x(i) + rest * (to.x(i) - from.x(i)), from.y(i) + rest * (to.y(i) - from.y(i)));
        });
  }

  private static Point2D place(double x, double y) {
    return Double.isFinite(x + y) ? new Point2D.Double(x, y) : null;
  }

  void draw(Graphics2D g, AffineTransform map, Color color) {
    for (int shade = 0; shade < SHADES; shade++) {
      double boldness = (shade + 1.0) / SHADES;
      g.setColor(Style.veil(color, BOLDEST * boldness * boldness));
      g.setStroke(Style.line(Style.HAIR + boldness * (Style.FIRM - Style.HAIR)));
      for (int i = 0; i < circles; i++) {
        double from = shade / (double) SHADES;
        double to = (shade + 1) / (double) SHADES;
        Path2D part = new Path2D.Double();
        join(part, map, i, from, course.at(i, from), to, course.at(i, to), HALVINGS);
        if (part.getCurrentPoint() != null) {
          g.draw(map.createTransformedShape(part));
        }
      }
    }
  }

  /** Halves a piece until it is straight, or short: flights are straight or nearly so. */
  private void join(
      Path2D path,
      AffineTransform map,
      int circle,
      double from,
      Point2D a,
      double to,
      Point2D b,
      int halvings) {
    double half = (from + to) / 2;
    Point2D middle = circles > MANY ? null : course.at(circle, half);
    if (halvings == 0 || circles > MANY || isStraight(map, a, middle, b)) {
      append(path, a);
      append(path, b);
    } else if (a != null || middle != null || b != null) {
      join(path, map, circle, from, a, half, middle, halvings - 1);
      join(path, map, circle, half, middle, to, b, halvings - 1);
    }
  }

  private static boolean isStraight(AffineTransform map, Point2D a, Point2D middle, Point2D b) {
    return a != null
        && middle != null
        && b != null
        && middle.distance((a.getX() + b.getX()) / 2, (a.getY() + b.getY()) / 2) * map.getScaleX()
            < STRAIGHT;
  }

  private static void append(Path2D path, Point2D at) {
    if (at != null && path.getCurrentPoint() == null) {
      path.moveTo(at.getX(), at.getY());
    } else if (at != null && !at.equals(path.getCurrentPoint())) {
      path.lineTo(at.getX(), at.getY());
    }
  }
}
