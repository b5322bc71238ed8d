// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

/**
 * A number of about 106 bits: the head is the double nearest to it, the tail the rest.
 *
 * <p>The bounds, in u^2 of the result: M. Joldes, J.-M. Muller and V. Popescu, Tight and rigorous
 * error bounds for basic building blocks of double-word arithmetic, ACM Transactions on
 * Mathematical Software 44 (2017). They hold as long as nothing underflows or overflows.
 */
public record DoubleDoubleNumber(double head, double tail) {

  /** The sum of a double and a much smaller one. */
  public static DoubleDoubleNumber of(double head, double tail) {
    double sum = head + tail;
    return new DoubleDoubleNumber(sum, tail - (sum - head));
  }

  /** The sum: 4. */
  public DoubleDoubleNumber plus(DoubleDoubleNumber that) {
    double sum = head + that.head;
    double tails = tail + that.tail;
    DoubleDoubleNumber near = of(sum, sumTail(head, that.head, sum) + tails);
    return of(near.head, near.tail + sumTail(tail, that.tail, tails));
  }

  /** The product: 5. */
  public DoubleDoubleNumber times(DoubleDoubleNumber that) {
    double product = head * that.head;
    double crossed = fma(head, that.tail, tail * that.head);
    return of(product, productTail(head, that.head, product) + crossed);
  }
}
