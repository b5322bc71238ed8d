// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Timeline;
import dev.carom.Uncertainty;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Locale;

/**
 * A photon among round mirrors: how far from the origin is it at time 10? Each reflection
 * multiplies the error, so few digits of a double are left. The digits that are sure are shown, and
 * no others.
 *
 * <p>Problem 2 of L. N. Trefethen, A Hundred-dollar, Hundred-digit Challenge, SIAM News 35 (2002).
 * Lengths are thirtieths, so that all numbers are integers: mirrors of radius 10 around the points
 * of a lattice of 30, and a photon at (15, 3) that flies in the direction of x.
 */
public final class Photon implements Example {

  /** The length of 1 in the scene; also the lattice. */
  static final double UNIT = 30;

  /** The time of the question: the photon flies 1 a unit of time. */
  static final double END = 10 * UNIT;

  private static final int MIRRORS = 3; // on each side of the origin; the photon stays among them
  private static final double KNOWN = UNIT / 100; // a place off by more is called unknown
  private static final int MOST_DIGITS = 17;

  private final SceneDrawing drawing = SceneDrawing.of(scene()).withArrowTime(0).withMargin(12);
  private World world;
  private Uncertainty uncertainty;
  private Timeline past;
  private int reflections;

  /** Starts it. */
  public Photon() {
    press();
  }

  /** {@return the mirrors, and the photon at its start} */
  public static Scene scene() {
    SceneBuilder scene = Scene.builder();
    for (int i = -MIRRORS; i <= MIRRORS; i++) {
      for (int j = -MIRRORS; j <= MIRRORS; j++) {
        scene.peg(UNIT * i, UNIT * j, UNIT / 3);
      }
    }
    return scene.circle(UNIT / 2, UNIT / 10, 0, 1, 0).build();
  }

  /** Begins again. */
  @Override
  public void press() {
    world = new World(scene());
    uncertainty = world.uncertainty(KNOWN);
    past = world.record(1000);
    reflections = 0;
  }

  @Override
  public void frame() {
    world.step(Math.min(1, END - world.now()));
    readLog();
  }

  private void readLog() {
    reflections += world.impacts().size();
  }

  int reflections() {
    return reflections;
  }

  /** The distance from the origin, in units of the problem. */
  double distance() {
    return Math.hypot(world.x(0), world.y(0)) / UNIT;
  }

  /** The same, with the digits that are sure. */
  String sureDistance() {
    double distance = distance();
    return sureDigits(distance, uncertainty.bound(0) / UNIT + 2 * Math.ulp(distance));
  }

  /** The digits that all numbers have in common that differ from a value by at most an error. */
  static String sureDigits(double value, double error) {
    if (!(error < Double.POSITIVE_INFINITY)) {
      return "?";
    }
    BigDecimal low = new BigDecimal(value).subtract(new BigDecimal(error));
    BigDecimal high = new BigDecimal(value).add(new BigDecimal(error));
    for (int digits = MOST_DIGITS; digits >= 0; digits--) {
      BigDecimal floor = low.setScale(digits, RoundingMode.FLOOR);
      if (floor.compareTo(high.setScale(digits, RoundingMode.FLOOR)) == 0) {
        return floor.toPlainString();
      }
    }
    return "?";
  }

  @Override
  public String hint() {
    return "Watch how few digits are sure after each reflection; click to begin again.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    double side = Math.min(area.getHeight(), 0.68 * area.getWidth());
    Rectangle2D square = new Rectangle2D.Double(area.getX(), area.getY(), side, area.getHeight());
    Path2D way = new Path2D.Double();
    way.moveTo(past.x(0, 0), past.y(0, 0));
    for (double t = 0; t <= world.now(); t += 0.25) {
      way.lineTo(past.x(0, t), past.y(0, t));
    }
    drawing.draw(g, square, Still.of(world).colored(i -> Style.VERMILION));
    g.setColor(Style.VERMILION);
    g.setStroke(Style.line(Style.FIRM));
    g.draw(drawing.transform(square).createTransformedShape(way));
    write(g, (float) square.getMaxX() + 12, (float) area.getY() + 90);
  }

  private void write(Graphics2D g, float x, float y) {
    g.setColor(Style.INK);
    g.setFont(Style.bold(20));
    g.drawString(sureDistance(), x, y + 30);
    g.setFont(Style.font(14));
    g.drawString("from the origin, the sure digits", x, y);
    g.setColor(Style.QUIET);
    g.drawString("computed: " + distance(), x, y + 60);
    String error = String.format(Locale.ROOT, "off by at most %.0e", uncertainty.bound(0) / UNIT);
    g.drawString(error, x, y + 84);
    String time = String.format(Locale.ROOT, "time %.1f of 10", world.now() / UNIT);
    g.drawString(time, x, y + 130);
    g.drawString("reflections: " + reflections, x, y + 154);
  }
}
