// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/** The test of the textbooks in float: the question is rounded first. */
final class TextbookFloatDetector extends LineDetector {

  private final TextbookFloatKernel kernel = new TextbookFloatKernel();

  @Override
  public double time(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double ax,
      double ay,
      double bx,
      double by,
      double end) {
    return kernel.time(
        (float) px,
        (float) py,
        (float) r,
        (float) vx,
        (float) vy,
        (float) ax,
        (float) ay,
        (float) bx,
        (float) by,
        (float) end);
  }
}
