// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.font.FontRenderContext;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.jfree.svg.SVGGraphics2D;
import org.jfree.svg.SVGHints;
import org.jfree.svg.ViewBox;

/**
 * Something to look at, of a fixed size, that can be had as pixels and as vectors.
 *
 * @param width in pixels, greater than 0
 * @param height in pixels, greater than 0
 * @param title what it shows, for those who cannot see it
 * @param painter draws it
 */
public record Picture(int width, int height, String title, Consumer<Graphics2D> painter) {

  /** The longest side of a picture of a scene. */
  public static final int WIDE = 900;

  /** The width of small charts: one fills a telephone, and three stand side by side on a desk. */
  public static final int PANEL = 380;

  /** Pixels of an image for each pixel of the picture: sharp on dense screens too. */
  private static final int DENSITY = 2;

  private static final Pattern TEXT =
      Pattern.compile("<text ([^>]*)font-size: ?(\\d+)px([^>]*)>([^<]*)</text>");

  /** Texts with fewer letters need no fitting. */
  private static final int SHORT = 4;

  private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

  /** First the font that texts are measured in, and its twin on other systems: as wide. */
  private static final String FONTS = "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif";

  /** Measures the room that a painter takes. It draws on an image of one pixel. */
  static double measured(ToDoubleFunction<Graphics2D> painter) {
    Graphics2D g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
    try {
      Style.smooth(g);
      return painter.applyAsDouble(g);
    } finally {
      g.dispose();
    }
  }

  /** Draws it in pixels, so many for one of the picture. */
  BufferedImage image(int density) {
    BufferedImage image =
        new BufferedImage(density * width, density * height, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    try {
      g.scale(density, density);
      paint(g);
    } finally {
      g.dispose();
    }
    return image;
  }

  /**
   * The bytes of a PNG file.
   *
   * @return the picture, two pixels for each of its own in either direction
   * @throws IOException if this Java cannot write PNG
   */
  public byte[] png() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    if (!ImageIO.write(image(DENSITY), "png", out)) {
      throw new IOException("this Java has no PNG writer");
    }
    return out.toByteArray();
  }

  /** The bytes of an SVG file, without anything that differs from run to run: the picture. */
  public byte[] svg() {
    return (svg("d") + "\n").getBytes(StandardCharsets.UTF_8);
  }

  /**
   * An SVG element, to stand in a page among others.
   *
   * @param prefix of the names that its parts refer to each other by, which no other has
   */
  public String svg(String prefix) {
    SVGGraphics2D g = new SVGGraphics2D(width, height);
    g.setDefsKeyPrefix(prefix);
    g.setGeomDoubleConverter(Picture::shorten);
    g.setTransformDoubleConverter(Picture::shorten);
    g.setFontFunction(family -> FONTS);
    g.setRenderingHint(SVGHints.KEY_ELEMENT_TITLE, title);
    g.setRenderingHint(SVGHints.KEY_BEGIN_GROUP, "picture");
    paint(g);
    g.setRenderingHint(SVGHints.KEY_END_GROUP, "picture");
    ViewBox whole = new ViewBox(0, 0, width, height); // lets a page scale it
    String element = g.getSVGElement(null, true, whole, null, null);
    return fitted(element.replaceAll("<g id='" + Hover.GROUP + "[0-9]+'>", "<g>"));
  }

  /** Texts get the lengths that they were laid out with, whatever font a reader has. */
  private static String fitted(String svg) {
    return TEXT.matcher(svg)
        .replaceAll(
            match -> {
              int size = Integer.parseInt(match.group(2));
              boolean bold = match.group(1).contains("bold") || match.group(3).contains("bold");
              String text = plain(match.group(4));
              if (text.length() < SHORT) {
                return Matcher.quoteReplacement(match.group());
              }
              Font font = bold ? Style.bold(size) : Style.font(size);
              double length = font.getStringBounds(text, CONTEXT).getWidth();
              return Matcher.quoteReplacement(
                  match
                      .group()
                      .replaceFirst("<text ", "<text textLength='" + shorten(length) + "' "));
            });
  }

  private static String plain(String escaped) {
    return escaped
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&apos;", "'")
        .replace("&amp;", "&");
  }

  private void paint(Graphics2D g) {
    Style.smooth(g);
    g.setColor(Style.PAPER);
    g.fillRect(0, 0, width, height);
    painter.accept(g);
  }

  /** A tenth of a pixel is as much as an eye can see. */
  private static String shorten(double x) {
    BigDecimal rounded = BigDecimal.valueOf(x).setScale(1, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }
}
