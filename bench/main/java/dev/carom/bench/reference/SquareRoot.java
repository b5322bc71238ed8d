// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import java.math.BigInteger;

/**
 * Square roots of integers of thousands of digits, in the time of about one division: that of
 * {@link BigInteger} divides by the whole number once for each doubling of the digits.
 *
 * <p>Source: P. Zimmermann, Karatsuba square root, INRIA research report 3805 (1999).
 */
final class SquareRoot {

  /** Below so many bits that of {@link BigInteger} is not slower. */
  private static final int FEW_BITS = 512;

  private SquareRoot() {}

  /** The greatest integer whose square is not greater than n >= 0, and what that leaves. */
  static BigInteger[] withRemainder(BigInteger n) {
    if (n.bitLength() <= FEW_BITS) {
      return n.sqrtAndRemainder();
    }
    int quarter = (n.bitLength() + 3) / 4;
    int half = (4 * quarter - n.bitLength()) / 2;
    if (half == 0) {
      return ofFourQuarters(n, quarter);
    }
    // The root of 4^half n, cut off, is the root of n.
    BigInteger root = ofFourQuarters(n.shiftLeft(2 * half), quarter)[0].shiftRight(half);
    return new BigInteger[] {root, n.subtract(root.multiply(root))};
  }

  /** The root of a number of {@code 4 quarter - 1} or {@code 4 quarter} bits, and the remainder. */
  private static BigInteger[] ofFourQuarters(BigInteger n, int quarter) {
    BigInteger[] high = withRemainder(n.shiftRight(2 * quarter));
    BigInteger low = part(n, 0, quarter);
    BigInteger rest = high[1].shiftLeft(quarter).add(part(n, quarter, quarter));
    BigInteger[] q = rest.divideAndRemainder(high[0].shiftLeft(1));
    BigInteger root = high[0].shiftLeft(quarter).add(q[0]);
    BigInteger left = q[1].shiftLeft(quarter).add(low).subtract(q[0].multiply(q[0]));
    if (left.signum() < 0) {
      left = left.add(root.shiftLeft(1)).subtract(BigInteger.ONE);
      root = root.subtract(BigInteger.ONE);
    }
    return new BigInteger[] {root, left};
  }

  private static BigInteger part(BigInteger n, int from, int bits) {
    BigInteger shifted = n.shiftRight(from);
    return shifted.subtract(shifted.shiftRight(bits).shiftLeft(bits));
  }
}
