// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import org.apache.commons.math3.stat.regression.SimpleRegression;

/**
 * How a time grows with a number: time = c number^slope, by least squares on the logarithms.
 *
 * @param slope 1 if twice the number takes twice the time
 * @param low the lower end of the slope's interval at a confidence of 95 %
 * @param high the upper end
 */
public record Growth(double slope, double low, double high) {

  /**
   * Fits it.
   *
   * @param numbers greater than 0, at least three
   * @param times as many, greater than 0
   */
  public static Growth of(double[] numbers, double[] times) {
    SimpleRegression fit = new SimpleRegression();
    for (int i = 0; i < numbers.length; i++) {
      fit.addData(Math.log(numbers[i]), Math.log(times[i]));
    }
    double half = fit.getSlopeConfidenceInterval();
    return new Growth(fit.getSlope(), fit.getSlope() - half, fit.getSlope() + half);
  }
}
