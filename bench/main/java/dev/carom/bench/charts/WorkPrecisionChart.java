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
 * best is at the left and below. All panels have the same axes.
 */
public final class WorkPrecisionChart {

  /** The unit of work. */
  public enum Work {
    /** Nanoseconds. */
    TIME,
    /** A number of operations. */
    COUNT
  }

  /** The height of a panel among others. */
  public static final int SMALL = 300;

  /** The height of a panel that is looked at first. */
  public static final int TALL = 400;

  private final String description;
  private final Marks marks;
  private final Work work;
  private final String errorLabel;
  private final String workLabel;
  private final Map<String, List<Dot>> panels;
  private final double budget;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param marks how methods are drawn
   * @param axes what stands at the axes: at the errors, at the work
   * @param work the kind of the work
   * @param budget a height to mark, NaN for none
   * @param panels the dots of each panel by its title, those of one method in the order of its knob
   */
  public WorkPrecisionChart(
      String description,
      Marks marks,
      List<String> axes,
      Work work,
      double budget,
      Map<String, List<Dot>> panels) {
    this.description = description;
    this.marks = marks;
    this.work = work;
    this.budget = budget;
    this.panels = new LinkedHashMap<>(panels);
    errorLabel = axes.get(0);
    workLabel = axes.get(1);
  }

  /** All panels, with the names of methods. */
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

  /** All panels have the same axes, since that is what they are compared by. */
  private void draw(Graphics2D g, Rectangle2D where, List<Dot> dots) {
    List<Dot> all = panels.values().stream().flatMap(List::stream).toList();
    DecadeAxis errors = DotPanel.errors(all, errorLabel);
    DotPanel.draw(g, where, errors, workAxis(all), marks, dots, budget);
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
    if (work == Work.TIME) {
      axis.withTexts(v -> Durations.text(v, 3));
    }
    return axis;
  }
}
