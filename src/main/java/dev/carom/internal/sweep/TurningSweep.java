// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.Gaps;
import dev.carom.internal.exact.Polynomial;
import dev.carom.internal.exact.PrecisionCounter;

/**
 * When a disk, straight on or with a constant acceleration, hits an obstacle that turns: {@link
 * FallSweep} and {@link FallReturn} for that. The rungs are the same but for the first one, {@link
 * TurnWindow}.
 *
 * <p>What turns is not convex in time. So a disk can come back to what it has just hit without an
 * acceleration. One that has left a side past an end of the line can hit any part of it later on.
 */
final class TurningSweep {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /**
   * Of the time of a turn by about two radians: the search in a window that ends where it begins.
   */
  private static final double PART = 0x1p-4;

  private TurningSweep() {}

  static double time(Fall f, double T) {
    PrecisionCounter.PARABOLAS.add();
    TurnWindow window = f.turnWindow();
    if (window.isClear(0, T, false)) {
      return NEVER;
    }
    double time = window.hit(T);
    time = Double.isNaN(time) ? searched(f, GapSearch.FIRST, 0, window.from, T) : time;
    return Double.isNaN(time) ? FallSweep.exact(f).time(T) : time;
  }

  static double timeAfter(Fall f, double s, double T) {
    PrecisionCounter.PARABOLAS.add();
    TurnWindow window = f.turnWindow();
    double start = Math.max(0, s);
    if (window.isClear(start, T, false)) {
      return NEVER;
    }
    // Just after an entry at s the search begins before it, where the gap has a sign.
    double from = window.from > start ? window.from : 0;
    double time = searched(f, GapSearch.ENTRY, s, from, T);
    return Double.isNaN(time) ? FallSweep.exact(f).timeAfter(s, T) : time;
  }

  static double timeOfReturn(Fall f, double T) {
    PrecisionCounter.PARABOLAS.add();
    TurnWindow window = f.turnWindow();
    if (window.isClear(0, T, true)) {
      return NEVER;
    }
    int region = FallReturn.region(f);
    double time =
        region == Gaps.BESIDE
            ? fromSide(f, T)
            : searched(f, GapSearch.RETURN, region, window.from, T);
    return Double.isNaN(time) ? FallReturn.exact(f).time(T) : time;
  }

  /** The disk is clear of the line until it is again as high above it as at the start. */
  private static double fromSide(Fall f, double T) {
    int side = FallReturn.side(f);
    double back = searched(f, GapSearch.RISE, side, 0, T);
    if (back == 0 || back == NEVER || Double.isNaN(back)) {
      return back;
    }
    int region = f.region(back);
    if (region == Gaps.BESIDE || region == Gaps.UNKNOWN) {
      boolean isBack = region == Gaps.BESIDE || FallReturn.isAtEnd(f, side, back);
      return isBack ? back : GapSearch.DOUBT;
    }
    double start = Math.max(back * (1 - GapRoot.MARGIN), f.turnWindow().from);
    double time = searched(f, GapSearch.FIRST, 0, start, T);
    return time > back ? time : GapSearch.DOUBT;
  }

  /** The answer of the second rung in what is left of the window; NaN if it leaves it open. */
  private static double searched(Fall f, int question, double of, double from, double T) {
    double part = PART / (Math.abs(f.turn.q1) + Math.abs(f.turn.q2));
    double reach = T > GapRoot.EARLIEST ? f.turnWindow().to : part;
    return FallSweep.searched(f, question, of, from, reach, T);
  }

  /**
   * The side of a line that is hit after a contact with a side; 0 in doubt. If it is the other one,
   * the disk may have come round an end, or be a point that was there by rounding; or the centre is
   * on the line.
   */
  static int side(Fall f, double t) {
    int side = FallReturn.side(f);
    return f.side(t) == side || back(f, side, t) == t ? side : 0;
  }

  /** When the disk is again as high above a side, soon after a time at the latest. */
  private static double back(Fall f, int side, double t) {
    double end = Fall.MORE * t;
    return f.search().exactly().time(GapSearch.RISE, side, 0, end, end);
  }

  /**
   * The side of a line to which a point on it, or a centre, leaves: by the speed off it, else by
   * the place, else by the acceleration.
   */
  static int leavesTo(Fall f, int place) {
    Gaps<Polynomial> gaps = f.gaps(Polynomial.EXACT);
    Polynomial rise = gaps.aboveStart(gaps.height(), Polynomial::constant);
    Polynomial slope = rise.derivative();
    int speed = slope.constant().firstSign();
    return speed != 0 || place != 0 ? (speed != 0 ? speed : place) : slope.firstSign();
  }
}
