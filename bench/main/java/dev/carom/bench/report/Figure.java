// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Picture;

/**
 * A figure of the report.
 *
 * @param id the name of its files, and its place in the page
 * @param heading what it is about
 * @param caption what it shows, in words: all that a reader who cannot see it needs
 * @param picture the chart
 * @param table the numbers behind it
 */
public record Figure(
    String id, String heading, String caption, Picture picture, ReportTable table) {}
