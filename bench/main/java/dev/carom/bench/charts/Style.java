// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;

/**
 * The one place with colours, fonts and line widths. Colours are those of Okabe and Ito (2008),
 * told apart by the colour-blind, on a paper that is nearly white; where one stands for a meaning,
 * a shape or a dash says the same, for those who read in grey.
 */
public final class Style {

  /**
   * The colours of a drawing that depend on whether it is light or dark.
   *
   * @param paper what everything is drawn on
   * @param floor the inside of a scene
   * @param ink text and obstacles
   * @param quiet text beside the point, still readable on the paper
   * @param grid lines of a grid
   * @param rim the outline of a circle
   */
  public record Scheme(Color paper, Color floor, Color ink, Color quiet, Color grid, Color rim) {

    /** Dark on light: that of charts and of printed pictures. */
    public static final Scheme LIGHT =
        new Scheme(Style.PAPER, Style.FLOOR, Style.INK, Style.QUIET, Style.GRID, Style.BLUE);

    /** Light on dark, for windows. */
    public static final Scheme DARK =
        new Scheme(
            new Color(0x1B1D21),
            new Color(0x24272C),
            new Color(0xE8E6E1),
            new Color(0xA3A8AF),
            new Color(0x3A3F46),
            Style.SKY);

    /**
     * The same with another floor.
     *
     * @param other the inside of a scene
     */
    public Scheme withFloor(Color other) {
      return new Scheme(paper, other, ink, quiet, grid, rim);
    }
  }

  /** Okabe-Ito blue. */
  public static final Color BLUE = new Color(0x0072B2);

  /** Okabe-Ito sky blue. */
  public static final Color SKY = new Color(0x56B4E9);

  /** Okabe-Ito bluish green. */
  public static final Color GREEN = new Color(0x009E73);

  /** Okabe-Ito orange. */
  public static final Color ORANGE = new Color(0xE69F00);

  /** Okabe-Ito vermilion. */
  public static final Color VERMILION = new Color(0xD55E00);

  /** Okabe-Ito reddish purple. */
  public static final Color PURPLE = new Color(0xCC79A7);

  /** Okabe-Ito yellow: for areas only, since lines in it vanish on paper. */
  public static final Color YELLOW = new Color(0xF0E442);

  /** The background. */
  public static final Color PAPER = new Color(0xFAF9F5);

  /** The inside of a scene. */
  public static final Color FLOOR = Color.WHITE;

  /** Text and obstacles. */
  public static final Color INK = new Color(0x22262B);

  /** Text beside the point; its contrast to the paper is still above 4.5 to 1. */
  public static final Color QUIET = new Color(0x62686F);

  /** Lines of a grid. */
  public static final Color GRID = new Color(0xE3E2DD);

  /** Widths of lines in pixels, from the thinnest. */
  public static final double HAIR = 0.75;

  /** The outline of a circle, the shaft of an arrow. */
  public static final double THIN = 1.25;

  /** Obstacles, and the lines of a chart that carry its message. */
  public static final double FIRM = 2;

  private static final String FAMILY = Font.SANS_SERIF;

  private Style() {}

  /**
   * The font of texts.
   *
   * @param size in pixels, greater than 0
   */
  public static Font font(double size) {
    return new Font(FAMILY, Font.PLAIN, 1).deriveFont((float) size);
  }

  /**
   * The font of titles and of what is to be read first.
   *
   * @param size in pixels, greater than 0
   */
  public static Font bold(double size) {
    return new Font(FAMILY, Font.BOLD, 1).deriveFont((float) size);
  }

  /**
   * A whole line with round ends, so that a line of no length is a dot.
   *
   * @param width in pixels, at least 0
   */
  public static BasicStroke line(double width) {
    return new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
  }

  /**
   * A broken line.
   *
   * @param width in pixels, greater than 0
   * @param on the length of a dash in pixels
   * @param off the length of a gap in pixels
   */
  public static BasicStroke dashes(double width, double on, double off) {
    float[] pattern = {(float) on, (float) off};
    return new BasicStroke(
        (float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, pattern, 0);
  }

  /**
   * A colour that lets through what lies under it.
   *
   * @param opacity from 0, nothing to be seen, to 1
   */
  public static Color veil(Color color, double opacity) {
    int alpha = (int) Math.round(255 * opacity);
    return new Color(color.getRed(), color.getGreen(), color.getBlue(), alpha);
  }

  /**
   * A colour between two.
   *
   * @param from the colour at 0
   * @param to the colour at 1
   * @param share from 0 to 1
   * @return the mixture
   */
  public static Color mix(Color from, Color to, double share) {
    return new Color(
        mix(from.getRed(), to.getRed(), share),
        mix(from.getGreen(), to.getGreen(), share),
        mix(from.getBlue(), to.getBlue(), share));
  }

  private static int mix(int from, int to, double share) {
    return (int) Math.round(from + (to - from) * share);
  }

  /**
   * Asks for smooth edges, true positions and smooth text.
   *
   * @param g what is drawn on
   */
  public static void smooth(Graphics2D g) {
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    g.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    g.setRenderingHint(
        RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
  }

  /**
   * Makes sure that text can be drawn. On a machine without fonts, such as a small container, Java
   * fails deep inside, with an {@code InternalError} that names no remedy.
   *
   * @throws IllegalStateException if there is no font; the message says what to install
   */
  public static void requireFonts() {
    try {
      font(12).getStringBounds("Carom", new FontRenderContext(null, true, true));
    } catch (LinkageError | InternalError | RuntimeException e) {
      throw new IllegalStateException(
          "Pictures need a font and this machine has none that Java can load: install one, on"
              + " Debian or Ubuntu with 'apt-get install fontconfig fonts-dejavu-core', on Alpine"
              + " with 'apk add fontconfig ttf-dejavu'",
          e);
    }
  }
}
