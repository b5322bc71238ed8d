// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigInteger;
import java.util.Random;
import org.junit.jupiter.api.Test;

class SquareRootTest {

  private static void check(BigInteger n) {
    assertThat(SquareRoot.withRemainder(n)).isEqualTo(n.sqrtAndRemainder());
  }

  @Test
  void rootsOfRandomNumbersAreExact() {
    Random random = new Random(1);
    for (int bits = 1; bits < 5000; bits += 13) {
      check(new BigInteger(bits, random));
      check(new BigInteger(bits, random).setBit(bits - 1));
    }
  }

  /** Where a root is one too large at first, or has no remainder. */
  @Test
  void rootsOfSquaresAndTheirNeighboursAreExact() {
    Random random = new Random(2);
    for (int bits = 200; bits < 2500; bits += 7) {
      BigInteger root = new BigInteger(bits, random).setBit(bits - 1);
      BigInteger square = root.multiply(root);
      check(square);
      check(square.subtract(BigInteger.ONE));
      check(square.add(BigInteger.ONE));
      check(square.add(root.shiftLeft(1)));
      check(BigInteger.ONE.shiftLeft(bits).subtract(BigInteger.ONE));
      check(BigInteger.ONE.shiftLeft(bits));
    }
  }

  @Test
  void smallNumbersHaveRootsToo() {
    for (int n = 0; n < 100; n++) {
      check(BigInteger.valueOf(n));
    }
  }
}
