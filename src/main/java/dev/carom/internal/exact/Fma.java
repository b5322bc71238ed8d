// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * Fused multiply-add, a b + c rounded once: everywhere the bits of {@link Math#fma}, which without
 * an instruction of the processor takes some 200 times as long as the sums of {@link #emulated}.
 *
 * <p>The choice is made once, by time, and changes speed only: {@link Math#fma} is used if its
 * fastest block of calls was faster than that of the sums. Three rounds are timed, and more for up
 * to 10 ms while the sums are faster, since some virtual machines use the instruction only in
 * compiled code. The constant lets the compiler remove the branch.
 */
public final class Fma {

  private static final int BLOCK = 16;

  /** In nanoseconds. */
  private static final long PATIENCE = 10_000_000;

  /**
   * Factors and summand up to BIG and a product from SMALL on keep every operation of {@link
   * #emulated} from overflow (2^500 2^500 + 2^500) and the tail of the product, a multiple of
   * 2^-106 |p|, from underflow. A NaN needs no branch: it passes through the sums.
   */
  private static final double BIG = 0x1p500;

  private static final double SMALL = 0x1p-900;

  private static final double FAR_ABOVE = SMALL * 0x1p60;

  private static final boolean IS_INSTRUCTION = isInstruction();

  private Fma() {}

  /** a b + c, rounded once. */
  public static double fma(double a, double b, double c) {
    return IS_INSTRUCTION ? Math.fma(a, b, c) : emulated(a, b, c);
  }

  /**
   * The same by sums and products without error: a b + c = s + e + q, with p = fl(a b), its tail q,
   * s = fl(p + c) and its tail e.
   *
   * <p>If e = 0, then s + q rounds once. Otherwise |s| >= |p|/2: below that p and c are within a
   * factor of 2, and s is exact. So e + q is at most 1.5 ulp(s), and a point half way between two
   * doubles near s differs from s by a multiple of ulp(s)/4, which is a double. Rounding e + q to
   * {@code rest} moves it onto such a point at most, never past it. So s + rest rounds right unless
   * it is half way, with the other neighbour at sum + 2 half. There the tail of e + q decides.
   */
  static double emulated(double a, double b, double c) {
    double p = a * b;
    if (Math.abs(a) > BIG || Math.abs(b) > BIG || Math.abs(c) > BIG || Math.abs(p) < SMALL) {
      // Also right where the product is 0, or far below the last place of the summand.
      boolean isSum = a == 0 || b == 0 || (Math.abs(p) < SMALL && Math.abs(c) > FAR_ABOVE);
      return isSum ? p + c : Math.fma(a, b, c);
    }
    double ah = upperHalf(a);
    double bh = upperHalf(b);
    double al = a - ah;
    double bl = b - bh;
    double q = al * bl - (((p - ah * bh) - al * bh) - ah * bl);
    double s = p + c;
    double e = DoubleDouble.sumTail(p, c, s);
    double rest = e + q;
    double sum = s + rest;
    double half = rest - (sum - s);
    if (half == 0 || sum + 2 * half - sum != 2 * half) {
      return sum;
    }
    double tail = DoubleDouble.sumTail(e, q, rest);
    return tail == 0 ? sum : s + (tail > 0 ? Math.nextUp(rest) : Math.nextDown(rest));
  }

  /** The upper 26 bits of a (Veltkamp): they and the rest multiply without error. */
  private static double upperHalf(double a) {
    double scaled = 0x8000001p0 * a;
    return scaled - (scaled - a);
  }

  private static boolean isInstruction() {
    long start = System.nanoTime();
    long instruction = Long.MAX_VALUE;
    long sums = Long.MAX_VALUE;
    for (int k = 0; k < 3 || (instruction >= sums && System.nanoTime() - start < PATIENCE); k++) {
      instruction = Math.min(instruction, nanosOfBlock(true));
      sums = Math.min(sums, nanosOfBlock(false));
    }
    return instruction < sums;
  }

  private static long nanosOfBlock(boolean instruction) {
    long start = System.nanoTime();
    double x = 1;
    for (int i = 0; i < BLOCK; i++) {
      x = instruction ? Math.fma(x, 0.7, 0.4) : emulated(x, 0.7, 0.4);
    }
    // The unused x would let a compiler leave out the loop.
    return System.nanoTime() - start + (x > 0 ? 0 : 1);
  }
}
