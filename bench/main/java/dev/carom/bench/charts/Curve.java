// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

/**
 * A line of a chart with a band around it.
 *
 * @param method its label, which says how it is drawn
 * @param knob its setting, printed at the end of the line; may be empty
 * @param x where values are, ascending
 * @param low the lower edge of the band
 * @param middle the line; NaN where there is no value
 * @param high the upper edge of the band
 */
@SuppressWarnings("ArrayRecordComponent") // series of a chart, compared by nobody
public record Curve(
    String method, String knob, double[] x, double[] low, double[] middle, double[] high) {

  /** Takes values as they are: whoever hands them over does not change them. */
  public Curve {
    if (low.length != x.length || middle.length != x.length || high.length != x.length) {
      throw new IllegalArgumentException(
          "%s: %d places, %d, %d and %d values: expected as many"
              .formatted(method, x.length, low.length, middle.length, high.length));
    }
  }

  /** The place of the last value of the line: its number, or -1 if there is none. */
  public int last() {
    int i = middle.length - 1;
    while (i >= 0 && Double.isNaN(middle[i])) {
      i--;
    }
    return i;
  }
}
