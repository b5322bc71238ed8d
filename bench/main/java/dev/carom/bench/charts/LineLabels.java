// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Names lines of a chart beside their right ends, instead of in a legend, without overlap. */
final class LineLabels {

  private static final double GAP = 15;
  private static final double LEADER = 14;

  private record Label(double y, String method, String detail) {}

  private final List<Label> labels = new ArrayList<>();
  private final Marks marks;

  LineLabels(Marks marks) {
    this.marks = marks;
  }

  /** Adds the name of a line that ends at a height, in pixels; the detail stands below it. */
  void add(double y, String method, String detail) {
    labels.add(new Label(y, method, detail));
  }

  /** Draws them right of x, between two heights. */
  void draw(Graphics2D g, double x, double top, double bottom) {
    List<Label> sorted = new ArrayList<>(labels);
    sorted.sort(Comparator.comparingDouble(Label::y));
    double each = sorted.stream().allMatch(label -> label.detail.isEmpty()) ? GAP : 2 * GAP;
    double[] wanted = sorted.stream().mapToDouble(Label::y).toArray();
    double[] places = spread(wanted, each, top + each / 2, bottom - each / 2);
    for (int i = 0; i < places.length; i++) {
      draw(g, sorted.get(i), x, places[i]);
    }
  }

  private void draw(Graphics2D g, Label label, double x, double y) {
    g.setColor(marks.color(label.method));
    g.setStroke(Style.line(Style.HAIR));
    g.draw(new Line2D.Double(x + 2, label.y, x + LEADER, y));
    float left = (float) (x + LEADER + 21);
    marks.draw(g, label.method, left - 12, y);
    g.setFont(Style.bold(11));
    g.setColor(Style.INK);
    g.drawString(marks.name(label.method), left, (float) y + 4);
    g.setColor(Style.QUIET);
    g.setFont(Style.font(11));
    g.drawString(label.detail, left, (float) y + 18);
  }

  /** Moves ascending places apart, as little as it takes from above, then back from below. */
  static double[] spread(double[] wanted, double gap, double top, double bottom) {
    double[] places = wanted.clone();
    double least = top;
    for (int i = 0; i < places.length; i++) {
      places[i] = Math.max(places[i], least);
      least = places[i] + gap;
    }
    double most = bottom;
    for (int i = places.length - 1; i >= 0; i--) {
      places[i] = Math.min(places[i], most);
      most = places[i] - gap;
    }
    return places;
  }
}
