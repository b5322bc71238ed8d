// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Names lines of a chart beside their right ends, instead of in a legend, without overlap. */
final class LineLabels {

  private static final double GAP = 38;
  private static final double NARROW_GAP = 15;
  private static final double LEADER = 14;

  private record Label(double y, String text, String detail, Color color) {}

  private final List<Label> labels = new ArrayList<>();
  private final double gap;
  private final Marks marks;

  /** For labels with details below them. */
  LineLabels() {
    this(GAP, null);
  }

  private LineLabels(double gap, Marks marks) {
    this.gap = gap;
    this.marks = marks;
  }

  /** For labels which are methods: each has its mark before it, a detail of a few below it. */
  static LineLabels of(Marks marks) {
    return new LineLabels(NARROW_GAP, marks);
  }

  /**
   * Adds the label of a line that ends at a height, in pixels; the detail stands below the text.
   */
  LineLabels add(double y, String text, String detail, Color color) {
    labels.add(new Label(y, text, detail, color));
    return this;
  }

  /** Draws them right of x, between two heights. */
  void draw(Graphics2D g, double x, double top, double bottom) {
    List<Label> sorted = new ArrayList<>(labels);
    sorted.sort(Comparator.comparingDouble(Label::y));
    boolean told = marks != null && sorted.stream().anyMatch(label -> !label.detail().isEmpty());
    double each = told ? 2 * gap : gap;
    double[] places =
        spread(
            sorted.stream().mapToDouble(Label::y).toArray(),
            each,
            top + each / 2,
            bottom - each / 2);
    for (int i = 0; i < places.length; i++) {
      draw(g, sorted.get(i), x, places[i]);
    }
  }

  private void draw(Graphics2D g, Label label, double x, double y) {
    g.setColor(label.color());
    g.setStroke(Style.line(Style.HAIR));
    g.draw(new Line2D.Double(x + 2, label.y(), x + LEADER, y));
    float left = (float) (x + LEADER + 5);
    if (marks != null) {
      marks.draw(g, label.text(), left + 4, y);
      left += 16;
      g.setFont(Style.bold(11));
      g.setColor(Style.INK);
      String name = marks.name(label.text());
      g.drawString(name, left, (float) y + 4);
      g.setColor(Style.QUIET);
      g.setFont(Style.font(11));
      g.drawString(label.detail(), left, (float) y + 18);
    } else {
      g.setFont(Style.bold(13));
      g.drawString(label.text(), left, (float) y - 1);
      g.setColor(Style.QUIET);
      g.setFont(Style.font(12));
      g.drawString(label.detail(), left, (float) y + 14);
    }
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
