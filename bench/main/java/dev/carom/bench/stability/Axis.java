// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.Locale;
import java.util.function.DoubleFunction;
import java.util.stream.IntStream;

/**
 * The quantity along one side of a map.
 *
 * @param label its name, with its unit
 * @param values ascending
 */
@SuppressWarnings("ArrayRecordComponent") // compared by nobody
public record Axis(String label, double[] values, DoubleFunction<String> text) {

  private static final int STRIDE = 3;

  /** Values that are printed as they are. */
  static Axis plain(String label, double... values) {
    return new Axis(label, values, Axis::plain);
  }

  private static String plain(double value) {
    return value == 0 ? "0" : BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
  }

  /** Powers of ten from one exponent to another, so many to a decade. */
  static Axis decades(String label, int from, int to, int each) {
    double[] values = new double[(to - from) * each + 1];
    Arrays.setAll(values, i -> power(from * each + i, each));
    return new Axis(label, values, Axis::power);
  }

  /** Whole powers to the last place. */
  private static double power(int steps, int each) {
    return steps % each == 0
        ? Double.parseDouble("1e" + steps / each)
        : StrictMath.pow(10, (double) steps / each);
  }

  /** A power of ten as such, and 1 as itself. */
  private static String power(double value) {
    double exponent = StrictMath.log10(value);
    if (value == 1) {
      return "1";
    }
    return exponent == StrictMath.rint(exponent)
        ? "1e" + (int) exponent
        : String.format(Locale.ROOT, "%.1e", value).replace("e+0", "e").replace("e-0", "e-");
  }

  /** Every third value, the last one too. */
  Axis thinned() {
    int n = values.length;
    double[] some =
        IntStream.range(0, n)
            .filter(i -> i % STRIDE == 0 || i == n - 1)
            .mapToDouble(i -> values[i])
            .toArray();
    return new Axis(label, some, text);
  }
}
