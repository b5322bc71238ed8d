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
import java.util.function.IntFunction;

/** The last places of circles, as lines that fade. */
final class Trails {

  /** Points of all trails together: what a frame has time for. */
  private static final int POINTS = 40_000;

  private static final int MOST_POINTS = 160;
  private static final int SHADES = 8;
  private static final double BOLDEST = 0.8;

  /** Tells where a circle was. */
  @FunctionalInterface
  private interface Course {

    /** Sets its place at a point of its trail; false if it was not there, or no trail began yet. */
    boolean find(int circle, int point, double[] place);
  }

  private final int circles;
  private final int points;
  private final Course course;

  private Trails(int circles, int points, Course course) {
    this.circles = circles;
    this.points = points;
    this.course = course;
  }

  /** Those of a recording: a trail turns where the circle did, and begins after the last jump. */
  static Trails of(Player player, double time) {
    Timeline past = player.past();
    int circles = player.circles();
    int most = Math.min(MOST_POINTS, POINTS / Math.max(1, circles));
    int points = Math.max(SHADES, most) / SHADES * SHADES;
    double end = player.shown();
    double begin = Math.max(past.start(), end - time);
    return new Trails(
        circles,
        points,
        (id, point, place) -> {
          double t = point == points ? end : begin + (end - begin) * point / points;
          if (t < player.lastJump(id) || !past.contains(Kind.CIRCLE, id, t)) {
            return false;
          }
          place[0] = past.x(id, t);
          place[1] = past.y(id, t);
          return true;
        });
  }

  /** Those of a duel: straight from frame to frame. */
  static Trails of(IntFunction<PlayedFrame> frames, int end, int length) {
    return new Trails(
        frames.apply(end).circles(),
        length,
        (i, point, place) -> {
          int frame = end - length + point;
          if (frame < 0) {
            return false;
          }
          place[0] = frames.apply(frame).x(i);
          place[1] = frames.apply(frame).y(i);
          return true;
        });
  }

  void draw(Graphics2D g, AffineTransform map, Color color) {
    for (int shade = 0; shade < SHADES; shade++) {
      double boldness = (shade + 1.0) / SHADES;
      g.setColor(Style.veil(color, BOLDEST * boldness * boldness));
      g.setStroke(Style.line(Style.HAIR + boldness * (Style.FIRM - Style.HAIR)));
      int from = shade * points / SHADES;
      int to = (shade + 1) * points / SHADES;
      for (int i = 0; i < circles; i++) {
        Path2D part = part(i, from, to);
        if (part.getCurrentPoint() != null) {
          g.draw(map.createTransformedShape(part));
        }
      }
    }
  }

  private Path2D part(int circle, int from, int to) {
    Path2D path = new Path2D.Double();
    double[] place = new double[2];
    for (int point = from; point <= to; point++) {
      if (course.find(circle, point, place) && Double.isFinite(place[0] + place[1])) {
        if (path.getCurrentPoint() == null) {
          path.moveTo(place[0], place[1]);
        } else {
          path.lineTo(place[0], place[1]);
        }
      }
    }
    return path;
  }
}
