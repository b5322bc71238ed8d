// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;

/**
 * Speed against accuracy: the error to the right, the time upwards, both logarithmic, so that the
 * best is at the left and below; a named dot for each method. The area in which a dot would be both
 * faster and more accurate than ours is shaded. All panels have the same axes.
 */
public final class DotChart {

  /** The height of a panel among others. */
  public static final int SMALL = 270;

  /** The height of a panel that is looked at first. */
  public static final int TALL = 360;

  private static final double GUTTER = 0.22;
  private static final double DOT = 6;
  private static final double WHISKER = 3;

  /** Where a text stands from its dot, in the order in which places are tried. */
  private static final double[][] SIDES = {
    {1, 0}, {-1, 0}, {0, -1}, {0, 1}, {-1, 1}, {1, 1}, {-1, -1}, {1, -1}
  };

  private static final double[] DISTANCES = {4, 12, 21, 33, 47, 63};
  private static final double JOINED_FROM = 12;

  private final String description;
  private final Marks marks;
  private final String errorLabel;
  private final String timeLabel;
  private final double budget;
  private final Map<String, List<Dot>> panels;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param marks how methods are drawn
   * @param axes what stands at the axes: at the errors, at the times
   * @param budget a time to mark, in nanoseconds; NaN for none
   * @param panels the dots of each panel by its title
   */
  public DotChart(
      String description,
      Marks marks,
      List<String> axes,
      double budget,
      Map<String, List<Dot>> panels) {
    this.description = description;
    this.marks = marks;
    this.budget = budget;
    this.panels = new LinkedHashMap<>(panels);
    errorLabel = axes.get(0);
    timeLabel = axes.get(1);
  }

  /** All panels. */
  public List<Panel> panels(int height) {
    Rectangle2D all = new Rectangle2D.Double(2, 0, Picture.PANEL - 4, height - 2);
    return panels.entrySet().stream()
        .map(
            panel ->
                new Panel(
                    panel.getKey(),
                    new Picture(
                        Picture.PANEL, height, description, g -> draw(g, all, panel.getValue()))))
        .toList();
  }

  private void draw(Graphics2D g, Rectangle2D where, List<Dot> dots) {
    List<Dot> all = panels.values().stream().flatMap(List::stream).toList();
    DecadeAxis errors =
        DecadeAxis.covering(
            all.stream().filter(dot -> !dot.failed()).mapToDouble(Dot::error), DotChart::power);
    errors.setLabel(errorLabel);
    boolean exact = dots.stream().anyMatch(Dot::exact);
    boolean failed = dots.stream().anyMatch(Dot::failed);
    double after = failed ? GUTTER : 0;
    if (exact) {
      errors.withZero(GUTTER, after);
    } else {
      errors.withGutters(0, after);
    }
    DecadeAxis times =
        DecadeAxis.covering(
            DoubleStream.concat(
                all.stream().flatMapToDouble(dot -> DoubleStream.of(dot.low(), dot.high())),
                DoubleStream.of(budget)),
            v -> Durations.text(v, 1));
    times.setLabel(timeLabel);
    new Drawing(g, Axes.draw(g, where, errors, times), errors).draw(dots);
  }

  private static String power(double value) {
    double exponent = Math.log10(value);
    return exponent > -3.5 && exponent < 6.5
        ? Durations.number(value, 1)
        : "1e" + Math.round(exponent);
  }

  private static String error(double value) {
    return value == 0 || (value > 1e-3 && value < 1e6)
        ? Durations.number(value, 2)
        : String.format(Locale.ROOT, "%.1e", value);
  }

  /** One panel while it is drawn. */
  private final class Drawing {

    private final Graphics2D g;
    private final Axes axes;
    private final DecadeAxis errors;
    private final Rectangle2D area;
    private final List<Rectangle2D> taken = new ArrayList<>();
    private List<Dot> dots = List.of();

    Drawing(Graphics2D g, Axes axes, DecadeAxis errors) {
      this.g = g;
      this.axes = axes;
      this.errors = errors;
      area = axes.area();
    }

    void draw(List<Dot> dots) {
      this.dots = dots;
      Comparator<Dot> oursLast = Comparator.comparing(dot -> Marks.isOurs(dot.method()));
      if (dots.stream().anyMatch(Dot::failed)) {
        gutter(axes.x(errors.most()));
      }
      budget();
      dots.stream()
          .filter(d -> Marks.isOurs(d.method()) && !d.failed() && !d.exact())
          .forEach(this::shade);
      dots.forEach(this::whisker);
      for (Dot dot : dots.stream().sorted(oursLast).toList()) {
        Predicate<Dot> isUnder =
            other -> !Marks.isOurs(other.method()) && box(other).intersects(box(dot));
        // The largest would cover what is at its place: there it is a ring.
        boolean ring = Marks.isOurs(dot.method()) && dots.stream().anyMatch(isUnder);
        Hover.over(g, text(dot), () -> mark(dot, ring));
        taken.add(box(dot));
      }
      dots.stream().sorted(oursLast.reversed()).forEach(this::name);
    }

    private void gutter(double left) {
      g.setColor(Style.PAPER);
      g.fill(box(left, area.getY(), area.getMaxX() - left, area.getHeight()));
      g.setFont(Style.font(12));
      g.setColor(Style.INK);
      double x = (left + area.getMaxX() - g.getFontMetrics().stringWidth("failed")) / 2;
      g.drawString("failed", (float) x, (float) area.getMaxY() + 16);
    }

    private void budget() {
      if (!Double.isNaN(budget)) {
        axes.level(g, budget, Style.QUIET, Style.dashes(Style.THIN, 7, 4));
        g.setFont(Style.font(11));
        String text = Durations.text(budget, 4) + ": 60 frames a second";
        double y = axes.y(budget) - 5;
        g.drawString(text, (float) area.getMinX() + 6, (float) y);
        taken.add(box(area.getMinX(), y - 12, area.getWidth(), 18));
      }
    }

    /** The area in which a dot would be faster and more accurate; beyond 0 there is none. */
    private void shade(Dot ours) {
      g.setColor(Style.veil(Style.BLUE, 0.15));
      double right = x(ours);
      g.fill(box(area.getX(), y(ours), right - area.getX(), area.getMaxY() - y(ours)));
    }

    private double x(Dot dot) {
      return dot.failed() ? (axes.x(errors.most()) + area.getMaxX()) / 2 : axes.x(dot.error());
    }

    /** Something that took no time at all cannot be had: what has none stands at the top. */
    private double y(Dot dot) {
      return Double.isFinite(dot.time()) ? axes.y(dot.time()) : area.getMinY() + 2 * DOT;
    }

    private void mark(Dot dot, boolean ring) {
      if (dot.failed()) {
        marks.drawFailure(g, dot.method(), x(dot), y(dot));
      } else if (ring) {
        marks.drawRing(g, dot.method(), x(dot), y(dot));
      } else {
        marks.draw(g, dot.method(), x(dot), y(dot));
      }
    }

    private String text(Dot dot) {
      String time = Double.isFinite(dot.time()) ? Durations.text(dot.time(), 3) : "no time";
      String error = dot.failed() ? "failed" : error(dot.error());
      return (marks.name(dot.method()) + " " + dot.knob()).strip() + ": " + time + ", " + error;
    }

    private void whisker(Dot dot) {
      if (dot.high() > dot.low()) {
        double x = x(dot);
        double top = axes.y(dot.high());
        double bottom = axes.y(dot.low());
        taken.add(box(x - WHISKER, top, 2 * WHISKER, bottom - top));
        g.setColor(marks.of(dot.method()).color());
        g.setStroke(Style.line(Style.THIN));
        g.draw(new Line2D.Double(x, top, x, bottom));
        g.draw(new Line2D.Double(x - WHISKER, top, x + WHISKER, top));
        g.draw(new Line2D.Double(x - WHISKER, bottom, x + WHISKER, bottom));
      }
    }

    /** At the first place near the dot that is free; joined to the dot if it is not very near. */
    private void name(Dot dot) {
      boolean ours = Marks.isOurs(dot.method());
      g.setFont(Style.bold(ours ? 13 : 11));
      String text = marks.name(dot.method());
      double w = g.getFontMetrics().stringWidth(text);
      double h = g.getFontMetrics().getAscent();
      for (double distance : DISTANCES) {
        for (double[] side : SIDES) {
          boolean joined = distance >= JOINED_FROM || side[0] * side[1] != 0;
          double away = distance + box(dot).getWidth() / 2;
          double left = x(dot) + side[0] * (away + w / 2) - w / 2;
          double within = Math.max(area.getMinX() + 2, Math.min(area.getMaxX() - 2 - w, left));
          double cy = y(dot) + side[1] * (away + h / 2);
          Rectangle2D place = box(within, cy - h / 2, w, h);
          boolean isLast = distance == DISTANCES[DISTANCES.length - 1];
          if (isLast || (isFree(dot, place) && (ours || joined || isNearest(dot, place)))) {
            if (joined) {
              g.setColor(Style.QUIET);
              g.setStroke(Style.line(Style.HAIR));
              g.draw(leader(dot, place));
            }
            g.setColor(ours ? Style.BLUE : Style.INK);
            g.drawString(text, (float) place.getX(), (float) (place.getMaxY() - 2));
            taken.add(place);
            return;
          }
        }
      }
    }

    private Line2D leader(Dot dot, Rectangle2D text) {
      double x = Math.max(text.getMinX(), Math.min(text.getMaxX(), x(dot)));
      double y = Math.max(text.getMinY(), Math.min(text.getMaxY(), y(dot)));
      double size = box(dot).getWidth() / 2;
      double edge = size / Math.max(size, Math.hypot(x - x(dot), y - y(dot)));
      double fromX = x(dot) + edge * (x - x(dot));
      return new Line2D.Double(fromX, y(dot) + edge * (y - y(dot)), x, y);
    }

    /** Whether no other dot is nearer to a text: it would be taken for that one's. */
    private boolean isNearest(Dot dot, Rectangle2D text) {
      return dots.stream().noneMatch(other -> length(other, text) < length(dot, text));
    }

    /** How far the middle of a dot is from a text. */
    private double length(Dot dot, Rectangle2D text) {
      double dx = Math.max(0, Math.max(text.getMinX() - x(dot), x(dot) - text.getMaxX()));
      double dy = Math.max(0, Math.max(text.getMinY() - y(dot), y(dot) - text.getMaxY()));
      return Math.hypot(dx, dy);
    }

    private boolean isFree(Dot dot, Rectangle2D place) {
      return area.contains(place)
          && taken.stream().noneMatch(place::intersects)
          && taken.stream()
              .filter(other -> !other.intersects(box(dot)))
              .noneMatch(leader(dot, place)::intersects);
    }

    private Rectangle2D box(Dot dot) {
      double size = Marks.isOurs(dot.method()) ? Marks.RING : DOT;
      return box(x(dot) - size, y(dot) - size, 2 * size, 2 * size);
    }

    private Rectangle2D box(double x, double y, double w, double h) {
      return new Rectangle2D.Double(x, y, w, h);
    }
  }
}
