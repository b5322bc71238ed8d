// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/**
 * Grids of cells, one panel a method: the class of each cell is a colour and a sign. A dark corner
 * marks cells in which no method can be asked to be right.
 */
public final class FailureMapChart {

  /**
   * The map of one method.
   *
   * @param method its label
   * @param knob its setting, may be empty
   * @param share what stands beside its name
   * @param classes by cells from the lower left, row by row: numbers of {@link FailureSigns}
   */
  public record Board(String method, String knob, String share, List<Integer> classes) {}

  /**
   * One side of all panels.
   *
   * @param label what varies
   * @param ticks the text of each value
   */
  public record Side(String label, List<String> ticks) {}

  private static final int COLUMNS = 3;
  private static final double LEFT = 58;
  private static final double RIGHT = 6;
  private static final double SPACE = 10;
  private static final double WIDE =
      (Picture.PANEL - LEFT - RIGHT - (COLUMNS - 1) * SPACE) / COLUMNS;
  private static final double HEAD = 31;
  private static final double CELL = 7;
  private static final double LEGEND = 26;
  private static final double FOOT = 40;
  private static final double LEGEND_LINE = 18;

  private final String description;
  private final Side x;
  private final Side y;
  private final List<String> legend;
  private final List<Boolean> limited;
  private final List<Board> panels;
  private final Marks marks;

  /**
   * Takes what is drawn.
   *
   * @param description what it shows, for those who cannot see it
   * @param marks how methods are named
   * @param x the lower side
   * @param y the left side
   * @param legend the names of the classes, then that of the dark corner; empty for one that does
   *     not occur
   * @param limited for each cell whether it has the dark corner
   * @param panels the methods
   */
  public FailureMapChart(
      String description,
      Marks marks,
      Side x,
      Side y,
      List<String> legend,
      List<Boolean> limited,
      List<Board> panels) {
    this.description = description;
    this.marks = marks;
    this.x = x;
    this.y = y;
    this.legend = List.copyOf(legend);
    this.limited = List.copyOf(limited);
    this.panels = List.copyOf(panels);
  }

  /** Draws it. */
  public Picture picture() {
    int bands = (panels.size() + COLUMNS - 1) / COLUMNS;
    double each = HEAD + CELL * y.ticks.size() + 6;
    double head = Picture.measured(this::head);
    int height = (int) Math.ceil(head + bands * each + FOOT);
    return new Picture(
        Picture.PANEL,
        height,
        description,
        g -> {
          double below = head(g);
          for (int i = 0; i < panels.size(); i++) {
            double left = LEFT + i % COLUMNS * (WIDE + SPACE);
            int band = i / COLUMNS;
            double top = below + band * each;
            panel(g, panels.get(i), left, top);
            if (i % COLUMNS == 0) {
              heights(g, top + HEAD);
            }
            if (i + COLUMNS >= panels.size()) {
              places(g, left, top + HEAD + CELL * y.ticks.size());
            }
          }
          labels(g, below + bands * each, bands * each);
        });
  }

  /** Titles and legend; tells where they end. */
  private double head(Graphics2D g) {
    return legend(g, 0) + LEGEND;
  }

  /** Tells where its last line begins. */
  private double legend(Graphics2D g, double above) {
    double top = above;
    double left = 4;
    g.setFont(Style.font(11));
    for (int i = 0; i < legend.size(); i++) {
      if (legend.get(i).isEmpty()) {
        continue;
      }
      double text = g.getFontMetrics().stringWidth(legend.get(i));
      if (left > 4 && left + 18 + text > Picture.PANEL - RIGHT) {
        left = 4;
        top += LEGEND_LINE;
      }
      Rectangle2D box = new Rectangle2D.Double(left, top + 4, 13, 13);
      boolean isClass = i <= FailureSigns.NO_ANSWER;
      int number = isClass ? i : FailureSigns.RIGHT;
      FailureSigns.fill(g, box, number);
      FailureSigns.sign(g, List.of(box), number);
      FailureSigns.corner(g, isClass ? List.of() : List.of(box), number);
      g.setColor(Style.INK);
      g.setFont(Style.font(11));
      g.drawString(legend.get(i), (float) (left + 18), (float) (top + 15));
      left += 18 + text + 12;
    }
    return top;
  }

  private void panel(Graphics2D g, Board panel, double left, double top) {
    String name = marks.name(panel.method);
    boolean ours = Marks.isOurs(panel.method);
    g.setFont(ours ? Style.bold(11) : Style.font(11));
    g.setColor(ours ? Style.BLUE : Style.INK);
    g.drawString(name, (float) left, (float) (top + HEAD - 18));
    g.setFont(Style.font(11));
    g.setColor(Style.QUIET);
    String note = panel.knob.isEmpty() ? panel.share : panel.knob + ": " + panel.share;
    g.drawString(note, (float) left, (float) (top + HEAD - 5));
    cells(g, panel.classes, left, top + HEAD);
  }

  /** Areas, a grid over them, and signs: a path of each class, so that an SVG stays small. */
  private void cells(Graphics2D g, List<Integer> classes, double left, double top) {
    for (int number = 0; number <= FailureSigns.NO_ANSWER; number++) {
      FailureSigns.fill(g, area(classes, number, left, top), number);
    }
    grid(g, left, top);
    for (int number = 0; number <= FailureSigns.NO_ANSWER; number++) {
      List<Rectangle2D> cells = new ArrayList<>();
      List<Rectangle2D> corners = new ArrayList<>();
      for (int i = 0; i < classes.size(); i++) {
        if (classes.get(i) == number) {
          cells.add(cell(i, 1, left, top));
          if (limited.get(i)) {
            corners.add(cell(i, 1, left, top));
          }
        }
      }
      FailureSigns.sign(g, cells, number);
      FailureSigns.corner(g, corners, number);
    }
  }

  /** Neighbours in a row that are of one class are one rectangle. */
  private Path2D area(List<Integer> classes, int number, double left, double top) {
    Path2D area = new Path2D.Double();
    int cells = x.ticks.size();
    for (int i = 0; i < classes.size(); i++) {
      int run = 0;
      while (i + run < classes.size()
          && classes.get(i + run) == number
          && i / cells == (i + run) / cells) {
        run++;
      }
      if (run > 0) {
        area.append(cell(i, run, left, top), false);
        i += run - 1;
      }
    }
    return area;
  }

  private Rectangle2D cell(int i, int run, double left, double top) {
    int cells = x.ticks.size();
    double each = WIDE / cells;
    int row = y.ticks.size() - 1 - i / cells;
    return new Rectangle2D.Double(left + i % cells * each, top + row * CELL, run * each, CELL);
  }

  private void grid(Graphics2D g, double left, double top) {
    Path2D lines = new Path2D.Double();
    double height = CELL * y.ticks.size();
    for (int i = 1; i < x.ticks.size(); i++) {
      double at = left + i * WIDE / x.ticks.size();
      lines.append(new Line2D.Double(at, top, at, top + height), false);
    }
    for (int i = 1; i < y.ticks.size(); i++) {
      lines.append(new Line2D.Double(left, top + i * CELL, left + WIDE, top + i * CELL), false);
    }
    g.setColor(Style.PAPER);
    g.setStroke(Style.line(Style.HAIR));
    g.draw(lines);
  }

  private void heights(Graphics2D g, double top) {
    int rows = y.ticks.size();
    int step = 1 + (int) (rows / (CELL * rows / 15));
    g.setFont(Style.font(11));
    g.setColor(Style.INK);
    for (int i = 0; i < rows; i += step) {
      String tick = y.ticks.get(i);
      double right = LEFT - 5 - g.getFontMetrics().stringWidth(tick);
      g.drawString(tick, (float) right, (float) (top + (rows - i) * CELL - 2));
    }
  }

  private void places(Graphics2D g, double left, double top) {
    int cells = x.ticks.size();
    double each = WIDE / cells;
    g.setFont(Style.font(11));
    g.setColor(Style.INK);
    int step = step(g, each);
    for (int i = 0; i < cells; i += step) {
      double text = g.getFontMetrics().stringWidth(x.ticks.get(i));
      double place = left + (i + 0.5) * each - text / 2;
      double inside = Math.max(left, Math.min(left + WIDE - text, place));
      g.drawString(x.ticks.get(i), (float) inside, (float) (top + 12));
    }
  }

  /** The least stride at which no tick that has a text touches the next. */
  private int step(Graphics2D g, double each) {
    int step = 1;
    while (step < x.ticks.size() && room(g, step, each) > step * each) {
      step++;
    }
    return step;
  }

  /** Room for the widest label, and for moving the first and the last one inwards. */
  private double room(Graphics2D g, int step, double each) {
    double widest = widest(g, step);
    return widest + 4 + Math.max(0, (widest - each) / 2);
  }

  private double widest(Graphics2D g, int step) {
    double widest = 0;
    for (int i = 0; i < x.ticks.size(); i += step) {
      widest = Math.max(widest, g.getFontMetrics().stringWidth(x.ticks.get(i)));
    }
    return widest;
  }

  private void labels(Graphics2D g, double bottom, double height) {
    g.setFont(Style.font(11));
    g.setColor(Style.QUIET);
    double middle = LEFT + (Picture.PANEL - LEFT - RIGHT) / 2;
    double text = g.getFontMetrics().stringWidth(x.label);
    g.drawString(x.label, (float) (middle - text / 2), (float) (bottom + 30));
    AffineTransform upright = g.getTransform();
    double tall = g.getFontMetrics().stringWidth(y.label);
    g.translate(12, bottom - height / 2 + tall / 2);
    g.rotate(-Math.PI / 2);
    g.drawString(y.label, 0f, 0f);
    g.setTransform(upright);
  }
}
