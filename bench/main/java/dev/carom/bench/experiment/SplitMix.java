// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

/**
 * SplitMix64: random numbers that are fixed for ever, which those of the Java platform are not
 * promised to be. Source: G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number
 * generators, OOPSLA 2014, figure 17.
 */
final class SplitMix {

  private static final long GOLDEN_GAMMA = 0x9e3779b97f4a7c15L;

  private long state;

  SplitMix(long seed) {
    state = seed;
  }

  private long next() {
    state += GOLDEN_GAMMA;
    long z = state;
    z = (z ^ z >>> 30) * 0xbf58476d1ce4e5b9L;
    z = (z ^ z >>> 27) * 0x94d049bb133111ebL;
    return z ^ z >>> 31;
  }

  /** Uniform in low..high: one of 2^53 equal steps, the last left out. */
  double between(double low, double high) {
    return low + (next() >>> 11) * 0x1p-53 * (high - low);
  }
}
