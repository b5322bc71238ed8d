// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;

/**
 * Work against precision: the error to the right, the work upwards, both logarithmic, so that the
 * best is at the left and below. One panel, or small multiples on the same axes.
 */
public final class WorkPrecisionChart {

  /** What work is counted in. */
  public enum Work {
    /** Nanoseconds. */
    TIME,
    /** A number of operations. */
    COUNT
  }

  private static final int HEAD = 70;
  private static final int NARROW_HEAD = 150;
  private static final int ONE = 460;
  private static final int NARROW_ONE = 520;
  private static final int MANY = 300;
  private static final int COLUMNS = 2;
  private static final double TITLE = 22;

  private final String title;
  private final String subtitle;
  private final Marks marks;
  private final Work work;
  private final String errorLabel;
  private final String workLabel;
  private final Map<String, List<Dot>> panels;
  private final double budget;

  /**
   * Takes what is drawn.
   *
   * @param title what the reader is to take home
   * @param subtitle what is shown
   * @param marks how methods are drawn
   * @param axes what stands at the axes: at the errors, at the work
   * @param work the kind of the work
   * @param budget a height to mark, NaN for none
   * @param panels the dots of each panel by its title, which does not show if there is only one;
   *     those of one method in the order of its knob
   */
  public WorkPrecisionChart(
      String title,
      String subtitle,
      Marks marks,
      List<String> axes,
      Work work,
      double budget,
      Map<String, List<Dot>> panels) {
    this.title = title;
    this.subtitle = subtitle;
    this.marks = marks;
    this.work = work;
    this.budget = budget;
    this.panels = new LinkedHashMap<>(panels);
    errorLabel = axes.get(0);
    workLabel = axes.get(1);
  }

  /**
   * Draws it.
   *
   * @param width {@link Picture#WIDE} or {@link Picture#NARROW}
   * @return the picture
   */
  public Picture picture(int width) {
    boolean narrow = width < Picture.WIDE;
    int columns = narrow ? 1 : COLUMNS;
    int rows = (panels.size() + columns - 1) / columns;
    int head = narrow ? NARROW_HEAD : HEAD;
    int height = head + (panels.size() == 1 ? (narrow ? NARROW_ONE : ONE) : rows * MANY);
    return new Picture(
        width,
        height,
        title + ". " + subtitle,
        g -> {
          double top = Heading.draw(g, width, title, subtitle);
          if (panels.size() == 1) {
            Rectangle2D all = new Rectangle2D.Double(10, top, width - 24, height - top - 8);
            draw(g, all, panels.values().iterator().next());
          } else {
            multiples(g, width, columns, top, (height - top - 8) / rows);
          }
        });
  }

  private void multiples(Graphics2D g, int whole, int columns, double top, double height) {
    double width = (whole - 24.0) / columns;
    int i = 0;
    for (Map.Entry<String, List<Dot>> panel : panels.entrySet()) {
      double x = 10 + i % columns * width;
      int row = i / columns;
      double y = top + row * height;
      g.setFont(Style.bold(13));
      g.setColor(Style.INK);
      g.drawString(panel.getKey(), (float) (x + 6), (float) (y + 15));
      draw(
          g, new Rectangle2D.Double(x, y + TITLE, width - 8, height - TITLE - 6), panel.getValue());
      i++;
    }
  }

  /** All panels have the same axes, since that is what they are compared by. */
  private void draw(Graphics2D g, Rectangle2D where, List<Dot> dots) {
    List<Dot> all = panels.values().stream().flatMap(List::stream).toList();
    DecadeAxis errors = DotPanel.errors(all, errorLabel);
    double scale = panels.size() == 1 ? 1 : 0.9;
    DotPanel.draw(g, where, errors, workAxis(all), marks, dots, budget, scale);
  }

  private DecadeAxis workAxis(List<Dot> all) {
    DoubleStream values =
        DoubleStream.concat(
            all.stream().flatMapToDouble(dot -> DoubleStream.of(dot.low(), dot.work(), dot.high())),
            DoubleStream.of(budget));
    DecadeAxis axis =
        DecadeAxis.covering(
            values, work == Work.TIME ? v -> Durations.text(v, 1) : v -> Durations.number(v, 1));
    axis.setLabel(workLabel);
    return axis;
  }
}
