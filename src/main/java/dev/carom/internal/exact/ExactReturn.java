// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * When a disk with a constant acceleration comes back to the thing that it has just hit, in exact
 * numbers.
 *
 * <p>The gap of that thing counts from the start: it is 0 there, whatever the rounded place says.
 * Its slope there counts as 0 if it is negative. The other parts of a line have the gaps that the
 * rounded place gives them.
 */
public final class ExactReturn {

  /** Against the part that was hit alone. */
  private final ExactParabola own;

  /** Against the whole line; null if the thing is no line. */
  private final ExactParabola line;

  /** The region of the line that was hit. */
  private final int part;

  /** The side of the line: +1 left, -1 right. */
  private final int side;

  /** Whether the last answer is a time at which the disk is again as high above that side. */
  private boolean isBack;

  /**
   * The return to a line or a disk.
   *
   * @param part the region in which the disk touches it
   * @param side the side of a line that it touches there
   */
  public ExactReturn(Gaps<Polynomial> gaps, boolean isLine, int part, int side) {
    Polynomial gap = part == Gaps.BESIDE ? gaps.height().signed(side) : gaps.gap(part);
    Polynomial above = gaps.aboveStart(gap, Polynomial::constant).fromStart();
    own = ExactParabola.ofGap(above, gaps.rate(above, Gaps.BEFORE, Polynomial::derivative));
    line = isLine ? ExactParabola.of(gaps, true) : null;
    this.part = part;
    this.side = side;
  }

  /** The correctly rounded time of the return, {@code +infinity} for none up to T. */
  public double time(double T) {
    RealRoot root = first(T);
    return root == null ? Double.POSITIVE_INFINITY : root.nearest();
  }

  /** The time of the return; null for none up to the window's end T. */
  public RealRoot first(double T) {
    PrecisionCounter.EXACT_PARABOLAS.add();
    RealRoot back = own.firstFrom(ExactParabola.START, T);
    if (line == null) {
      return back;
    }
    return part == Gaps.BESIDE ? fromSide(back, T) : fromEnd(back, T);
  }

  /** A return to the side beyond an end of the line is none: the line can be hit from then on. */
  private RealRoot fromSide(RealRoot back, double T) {
    isBack = back == null || line.isBeside(back);
    if (isBack) {
      return back;
    }
    return line.turns() ? line.firstFrom(back, T) : line.part(line.region(back)).firstFrom(back, T);
  }

  private RealRoot fromEnd(RealRoot back, double T) {
    if (back != null && back.compare(Dyadic.ZERO) == 0) {
      return back;
    }
    RealRoot next = line.withGap(part, own).firstFall(ExactParabola.START, T);
    if (!line.isPoint()) {
      return next;
    }
    RealRoot other = line.firstOfPoint(part, T);
    return next == null || (other != null && other.compare(next) < 0) ? other : next;
  }

  /** The region of the line at a time. */
  public int region(RealRoot t) {
    return line.region(t);
  }

  /** The side of the line that is hit at a time: +1 left, -1 right. */
  public int side(RealRoot t) {
    return isBack ? side : line.side(t);
  }
}
