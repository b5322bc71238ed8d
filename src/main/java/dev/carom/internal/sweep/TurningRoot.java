// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.BoundedNumber;
import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Gaps;
import dev.carom.internal.exact.TurningGaps;
import dev.carom.internal.exact.UnitVector;

/**
 * Rounds the time of an impact on an obstacle that turns, as {@link GapRoot} does, and finds the
 * normal there. The residue is a {@link BoundedNumber}.
 *
 * <p>The residue errs by 143 u^2 of its terms A, a step of {@code x t} at least half an ulp has
 * {@code u <= 2 x}. The slope errs by 60 u of {@code 8 A / t}: a place and a speed as seen from the
 * obstacle have 16 u each, the offset from its nearest point 8 u more, and the factors n and w.w 15
 * u. It leaves out {@code 2 g n' / n}, at most 96 x A / t as the gap is a step times the slope. The
 * bend is 56 A / t^2 at most. So the residue plus a step errs by less than {@code (4 * 143 + 2 * 8
 * * 60 + 96 + 28) x^2 A}, which {@link GapRoot#nearest} covers.
 */
final class TurningRoot {

  /** 143 u^2, and more for the rounding of the terms themselves. */
  private static final double RESIDUE_BOUND = 160 * 0x1p-106;

  private final Fall f;

  private final BoundedNumber.AtTime numbers = new BoundedNumber.AtTime();

  private final TurningGaps<BoundedNumber> gaps = new TurningGaps<>();

  TurningRoot(Fall f) {
    this.f = f;
  }

  private TurningGaps<BoundedNumber> at(double t, double rest) {
    return f.turningGaps(numbers.at(t, rest), gaps);
  }

  /** The sign of the gap of a region at a time; {@link GapPolynomial#UNKNOWN} in doubt. */
  int sign(int region, double t) {
    BoundedNumber residue = at(t, 0).gap(region);
    boolean isCertain = Math.abs(residue.head()) > RESIDUE_BOUND * residue.terms();
    return isCertain ? UnitVectors.sign(residue.head()) : GapPolynomial.UNKNOWN;
  }

  /** The double nearest to the root of the gap of a region beside a time; NaN in doubt. */
  double nearest(int region, double start) {
    double t = start;
    double nearest = GapRoot.DOUBT;
    for (int i = 0; i < GapRoot.CORRECTIONS && Double.isNaN(nearest); i++) {
      BoundedNumber residue = at(t, 0).gap(region);
      double slope = f.turnWindow().slope(region, t);
      nearest = GapRoot.nearest(t, residue.head(), slope, Math.sqrt(residue.terms()));
      t -= residue.head() / slope;
    }
    return nearest;
  }

  /** The unit normal to the left of a line, or to the right for the side -1, at a time. */
  UnitVector ofSide(UnitVector out, int side, double t) {
    TurningGaps<BoundedNumber> here = at(t, 0);
    return UnitVectors.normal(out, side, 0, 0, here.lineX().head(), here.lineY().head());
  }

  /**
   * The unit normal at an impact on the end of a line in a region, or on a disk; null if
   * double-double does not tell.
   */
  UnitVector ofEnd(int region, double t) {
    double qx = region == Gaps.BEYOND ? f.bx : f.ax;
    double qy = region == Gaps.BEYOND ? f.by : f.ay;
    if (t == 0) {
      boolean haveOneCentre = f.px == qx && f.py == qy;
      return haveOneCentre ? null : UnitVectors.unit(f.px, f.py, qx, qy);
    }
    BoundedNumber residue = at(t, 0).gap(region);
    double slope = f.turnWindow().slope(region, t);
    double c = -residue.head() / slope;
    double error = GapRoot.stepError(t, c, slope, Math.sqrt(residue.terms()));
    TurningGaps<BoundedNumber> here = at(t, c);
    BoundedNumber x = here.x(region);
    BoundedNumber y = here.y(region);
    // An offset changes by 4 times its terms in the time t, or less.
    return error * 4 * (x.terms() + y.terms()) < 0x1p-55 * (f.r + f.radius) * t * f.turn.at(t).n
        ? UnitVectors.unit(x.head(), y.head(), 0, 0)
        : null;
  }
}
