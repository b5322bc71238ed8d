// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

/**
 * How far rounding may carry a centre from where real arithmetic has it, in one flight: some ulps
 * of the largest coordinate; what the speed in it and after it makes of an ulp of the clock, since
 * a log and a timeline are asked in doubles and the world's clock is finer; and what is left of a
 * velocity along a normal after a response has taken it away, an ulp of the largest speed that ever
 * was.
 */
final class Rounding {

  private static final double ULPS = 32;

  /** Ulps of the clock at either end. */
  private static final double CLOCK_ULPS = 4;

  private static final double RESIDUE = 0x1p-48;

  private double largest;
  private double fastest;

  void keepPlace(double... coordinates) {
    for (double c : coordinates) {
      largest = Double.isFinite(c) ? Math.max(largest, Math.abs(c)) : largest;
    }
  }

  void keepSpeed(double vx, double vy) {
    double speed = Math.abs(vx) + Math.abs(vy);
    fastest = Double.isFinite(speed) ? Math.max(fastest, speed) : fastest;
  }

  double fastest() {
    return fastest;
  }

  double of(Flight f) {
    return ULPS * Math.ulp(Math.max(largest, f.radius()))
        + CLOCK_ULPS * f.fastest() * Math.ulp(f.to())
        + RESIDUE * fastest * (f.to() - f.from());
  }

  /** The same for a velocity in a flight, with a given acceleration. */
  double ofVelocity(Flight f, double acceleration) {
    return RESIDUE * f.fastest() + CLOCK_ULPS * acceleration * Math.ulp(f.to());
  }
}
