// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Picture;
import java.util.function.IntFunction;

/**
 * A figure of the report.
 *
 * @param id the name of its files, and its place in the page
 * @param heading what it is about
 * @param caption what it shows, in words: all that a reader who cannot see it needs
 * @param picture the chart
 * @param narrow the same for narrow screens
 * @param table the numbers behind it
 */
public record Figure(
    String id, String heading, String caption, Picture picture, Picture narrow, ReportTable table) {

  /**
   * A figure that can be drawn in different widths.
   *
   * @param id the name of its files, and its place in the page
   * @param heading what it is about
   * @param caption what it shows
   * @param chart draws it in a width
   * @param table the numbers behind it
   */
  Figure(String id, String heading, String caption, IntFunction<Picture> chart, ReportTable table) {
    this(id, heading, caption, chart.apply(Picture.WIDE), chart.apply(Picture.NARROW), table);
  }
}
