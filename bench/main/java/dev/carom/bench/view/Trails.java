// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Timeline;
import dev.carom.bench.charts.Style;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;

/** Where circles were lately, from the recording: a trail turns where the circle did, and fades. */
final class Trails {

  /** Points of all trails together: what a frame has time for. */
  private static final int POINTS = 40_000;

  private static final int MOST_POINTS = 160;
  private static final int SHADES = 8;
  private static final double BOLDEST = 0.8;

  private final Player player;
  private final Timeline past;
  private final double begin;
  private final double end;
  private final int points;

  Trails(Player player, double time) {
    this.player = player;
    past = player.past();
    end = player.shown();
    begin = Math.max(past.start(), end - time);
    int most = POINTS / Math.max(1, player.circles());
    points = Math.max(SHADES, Math.min(MOST_POINTS, most)) / SHADES * SHADES;
  }

  void draw(Graphics2D g, AffineTransform map, Color color) {
    for (int shade = 0; shade < SHADES; shade++) {
      double boldness = (shade + 1.0) / SHADES;
      g.setColor(Style.veil(color, BOLDEST * boldness * boldness));
      g.setStroke(Style.line(Style.HAIR + boldness * (Style.FIRM - Style.HAIR)));
      int from = shade * points / SHADES;
      int to = (shade + 1) * points / SHADES;
      for (int id = 0; id < player.circles(); id++) {
        Path2D part = part(id, from, to);
        if (part.getCurrentPoint() != null) {
          g.draw(map.createTransformedShape(part));
        }
      }
    }
  }

  /** From one point of the trail to another one; what lies before the last jump is left out. */
  private Path2D part(int id, int from, int to) {
    double jump = player.lastJump(id);
    Path2D path = new Path2D.Double();
    for (int i = from; i <= to; i++) {
      double t = i == points ? end : begin + (end - begin) * i / points;
      if (t >= jump && past.contains(id, t)) {
        double x = past.x(id, t);
        double y = past.y(id, t);
        if (path.getCurrentPoint() == null) {
          path.moveTo(x, y);
        } else if (Double.isFinite(x + y)) {
          path.lineTo(x, y);
        }
      }
    }
    return path;
  }
}
