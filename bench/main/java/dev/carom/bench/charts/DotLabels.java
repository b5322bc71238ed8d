// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.font.FontRenderContext;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Texts beside dots, none over another or over a dot: each takes the cheapest of the places around
 * its dot, the nearest first (point-feature labels as by J. Christensen, J. Marks and S. Shieber,
 * 1995, greedily), and then again, now that the others stand; so in several orders, of which the
 * cheapest outcome is drawn. A text that found no place near is joined to its dot by a hair line.
 */
final class DotLabels {

  /** A text, the dot that it belongs to, and where it ended up. */
  record Label(double x, double y, String text) {

    List<String> lines() {
      return text.lines().toList();
    }
  }

  /** Where a text stands, and what that costs were it alone. */
  record Placed(Label label, Rectangle2D box, double alone) {}

  private static final Font FONT = Style.bold(11);

  private static final double[] DISTANCES = {8, 14, 22, 32, 44, 58, 74, 92, 112, 134};
  private static final int DIRECTIONS = 16;
  private static final int ROUNDS = 4;

  /** Orders in which labels choose their places. Of equal costs the first wins. */
  private static final List<Comparator<Label>> ORDERS =
      List.of(
          Comparator.comparingDouble(Label::x),
          Comparator.comparingDouble(Label::x).reversed(),
          Comparator.comparingDouble(Label::y),
          Comparator.comparingDouble(Label::y).reversed());

  private static final double MARGIN = 1.5;
  private static final double TEXT_MARGIN = 4;
  private static final double JOINED_FROM = 15;

  /** The cost of covering the whole of a text by texts or dots. */
  private static final double COVERED = 1000;

  /** The cost of a line through a text: more than that of the farthest place. */
  private static final double UNDERLINED = 160;

  /** The cost of another dot on the line from a text to its dot. */
  private static final double CROSSED = 40;

  /** The cost of another text on the line from a text to its dot. */
  private static final double STRUCK = 300;

  private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

  private final Rectangle2D area;
  private final List<Rectangle2D> dots = new ArrayList<>();
  private final List<Line2D> lines = new ArrayList<>();
  private final List<Label> labels = new ArrayList<>();

  /** Takes the area that no text may leave. */
  DotLabels(Rectangle2D area) {
    this.area = area;
  }

  /** Keeps texts off a dot. */
  DotLabels avoid(double x, double y, double radius) {
    dots.add(new Rectangle2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
    return this;
  }

  /** Keeps texts off an area. */
  DotLabels avoid(Rectangle2D taken) {
    dots.add(taken);
    return this;
  }

  /** Keeps texts off a line, if that does not take them far away. */
  DotLabels avoid(double x1, double y1, double x2, double y2) {
    lines.add(new Line2D.Double(x1, y1, x2, y2));
    return this;
  }

  /** Adds a text. */
  DotLabels add(double x, double y, String text) {
    labels.add(new Label(x, y, text));
    return this;
  }

  void draw(Graphics2D g) {
    for (Placed placed : place()) {
      Label label = placed.label;
      Rectangle2D box = placed.box;
      join(g, label, box);
      g.setFont(FONT);
      g.setColor(Style.INK);
      Rectangle2D line = line(label.text);
      double base = box.getY() - line.getY();
      for (String text : label.lines()) {
        g.drawString(text, (float) box.getX(), (float) base);
        base += line.getHeight();
      }
    }
  }

  private static void join(Graphics2D g, Label label, Rectangle2D box) {
    Line2D leader = leader(label, box);
    if (leader != null) {
      g.setColor(Style.QUIET);
      g.setStroke(Style.line(Style.HAIR));
      g.draw(leader);
    }
  }

  /** From the edge of the dot to the nearest place of the text, or null if that is near. */
  private static Line2D leader(Label label, Rectangle2D box) {
    double x = Math.max(box.getMinX(), Math.min(box.getMaxX(), label.x));
    double y = Math.max(box.getMinY(), Math.min(box.getMaxY(), label.y));
    double distance = Math.hypot(x - label.x, y - label.y);
    if (distance <= JOINED_FROM) {
      return null;
    }
    double share = 7 / distance;
    return new Line2D.Double(
        label.x + share * (x - label.x), label.y + share * (y - label.y), x, y);
  }

  /** The cheapest of what comes out if these choose first, or those. */
  List<Placed> place() {
    List<Placed> best = List.of();
    double least = Double.POSITIVE_INFINITY;
    for (Comparator<Label> order : ORDERS) {
      List<Placed> placed = place(labels.stream().sorted(order).toList());
      double cost = placed.stream().mapToDouble(p -> cost(p, without(p, placed))).sum();
      if (cost < least) {
        least = cost;
        best = placed;
      }
    }
    return best;
  }

  private List<Placed> place(List<Label> sorted) {
    List<Placed> placed = new ArrayList<>();
    for (Label label : sorted) {
      placed.add(best(label, placed));
    }
    for (int round = 0; round < ROUNDS; round++) {
      for (Label label : sorted) {
        placed.remove(0);
        placed.add(best(label, placed));
      }
    }
    return placed;
  }

  private static List<Placed> without(Placed one, List<Placed> placed) {
    return placed.stream().filter(other -> !other.equals(one)).toList();
  }

  private Placed best(Label label, List<Placed> placed) {
    Placed best = null;
    double least = Double.POSITIVE_INFINITY;
    for (double distance : DISTANCES) {
      for (int i = 0; i < DIRECTIONS; i++) {
        double angle = 2 * Math.PI * i / DIRECTIONS;
        double own = distance + (i % 8 == 0 ? 0 : 1);
        Placed here = new Placed(label, box(label, distance, angle), own);
        double cost = cost(here, placed);
        if (cost < least) {
          least = cost;
          best = here;
        }
      }
    }
    return best;
  }

  /** The text's box, its nearest edge or corner at a distance from the dot; 0 is to the right. */
  private Rectangle2D box(Label label, double distance, double angle) {
    Rectangle2D size = metrics(label);
    double w = size.getWidth();
    double h = size.getHeight();
    double dx = Math.cos(angle);
    double dy = -Math.sin(angle);
    double x = label.x + distance * dx + (dx - 1) * w / 2;
    double y = label.y + distance * dy + (dy - 1) * h / 2;
    x = Math.max(area.getMinX(), Math.min(area.getMaxX() - w, x));
    y = Math.max(area.getMinY(), Math.min(area.getMaxY() - h, y));
    return new Rectangle2D.Double(x, y, w, h);
  }

  private static Rectangle2D metrics(Label label) {
    double width = 0;
    double height = 0;
    for (String text : label.lines()) {
      Rectangle2D line = line(text);
      width = Math.max(width, line.getWidth());
      height += line.getHeight();
    }
    return new Rectangle2D.Double(0, 0, width, height);
  }

  private static Rectangle2D line(String text) {
    return FONT.getStringBounds(text, CONTEXT);
  }

  private double cost(Placed one, List<Placed> placed) {
    Label label = one.label;
    Rectangle2D box = one.box;
    Line2D leader = leader(label, box);
    double cost = one.alone;
    for (Placed other : placed) {
      Line2D theirs = leader(other.label, other.box);
      cost += covered(box, other.box, TEXT_MARGIN);
      cost += leader != null && leader.intersects(other.box) ? STRUCK : 0;
      cost += theirs != null && theirs.intersects(box) ? STRUCK : 0;
    }
    for (Rectangle2D dot : dots) {
      cost += covered(box, dot, MARGIN);
      boolean own = dot.contains(label.x, label.y);
      cost += leader != null && !own && leader.intersects(dot) ? CROSSED : 0;
    }
    for (Line2D line : lines) {
      cost += line.intersects(box) ? UNDERLINED : 0;
    }
    return cost;
  }

  /** The less of two boxes is free, the more it costs, with a step: to touch is bad enough. */
  private static double covered(Rectangle2D box, Rectangle2D other, double margin) {
    double w = Math.min(box.getMaxX(), other.getMaxX()) - Math.max(box.getMinX(), other.getMinX());
    double h = Math.min(box.getMaxY(), other.getMaxY()) - Math.max(box.getMinY(), other.getMinY());
    if (w <= -margin || h <= -margin) {
      return 0;
    }
    double shared = (w + margin) * (h + margin);
    return COVERED * (0.2 + shared / (box.getWidth() * box.getHeight()));
  }
}
