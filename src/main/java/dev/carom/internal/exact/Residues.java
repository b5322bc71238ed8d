// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import java.util.Arrays;

/**
 * Polynomials with their coefficients modulo a prime: a quick proof that two of them have no common
 * divisor.
 *
 * <p>A common divisor h has integer coefficients but for powers of two, and its leading one divides
 * that of f. If that of f is not 0 modulo the prime, neither is that of h. So h is as long modulo
 * the prime, and divides both polynomials there, too. If they have no common divisor there, they
 * have none.
 */
final class Residues {

  /** 2^31 - 1: a product of two residues is a long. */
  static final long PRIME = (1L << 31) - 1;

  private Residues() {}

  /** Whether two polynomials, the constant coefficient first, are certain to be coprime. */
  static boolean areCoprime(Dyadic[] f, Dyadic[] g) {
    long[] a = of(f);
    long[] b = of(g);
    if (a.length < f.length) {
      return false;
    }
    while (b.length > 0) {
      long[] rest = remainder(a, b);
      a = b;
      b = rest;
    }
    return a.length == 1;
  }

  private static long[] of(Dyadic[] f) {
    return trimmed(Arrays.stream(f).mapToLong(Dyadic::residue).toArray());
  }

  /** A multiple of the remainder. */
  private static long[] remainder(long[] a, long[] b) {
    long[] rest = a.clone();
    long lead = b[b.length - 1];
    for (int k = rest.length - 1; k >= b.length - 1; k--) {
      long factor = PRIME - rest[k];
      for (int i = 0; i < k; i++) {
        int j = i - (k - b.length + 1);
        long part = j < 0 ? 0 : factor * b[j] % PRIME;
        rest[i] = (rest[i] * lead + part) % PRIME;
      }
      rest[k] = 0;
    }
    return trimmed(rest);
  }

  /** Without the leading coefficients that are 0. */
  private static long[] trimmed(long[] f) {
    int length = f.length;
    while (length > 0 && f[length - 1] == 0) {
      length--;
    }
    return Arrays.copyOf(f, length);
  }
}
