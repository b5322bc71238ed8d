// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.RealRoot;

/** Questions about things that turn, with the numbers of {@code TurningQuery} in one call. */
public final class TurningFalls {
  private TurningFalls() {}

  /** The question in its numbers, of a line or a peg. */
  public static Fall fall(double... n) {
    Fall fall = new Fall().flight(n[5], n[6], n[7], n[8], n[9], n[10], n[11]);
    if (n[0] != n[2] || n[1] != n[3]) {
      fall.line(n[0], n[1], n[2], n[3], 0, 0);
    } else {
      fall.disk(n[0], n[1], n[4], 0, 0);
    }
    return fall.turn(n[12], n[13], n[14], n[15]);
  }

  /** The time of the first impact, of the return or of a later entry, and the contact. */
  public static double[] answer(int kind, double... n) {
    Fall fall = fall(n);
    double time =
        switch (kind) {
          case 0 -> FallSweep.time(fall, n[17]);
          case 1 -> FallReturn.time(fall, n[17]);
          default -> FallSweep.timeAfter(fall, n[16], n[17]);
        };
    boolean isMiss = time == GapSearch.NEVER;
    int contact =
        isMiss ? 0 : kind == 1 ? FallReturn.contact(fall, time) : FallSweep.contact(fall, time);
    return new double[] {time, contact};
  }

  /** The time alone, in algebraic numbers. */
  public static double exactTime(int kind, double... n) {
    Fall fall = fall(n);
    return switch (kind) {
      case 0 -> FallSweep.exact(fall).time(n[17]);
      case 1 -> FallReturn.exact(fall).time(n[17]);
      default -> FallSweep.exact(fall).timeAfter(n[16], n[17]);
    };
  }

  /** The contact at an exact time, as {@link #answer} gives it. */
  static int exactContact(RealRoot time, double... n) {
    ExactParabola exact = FallSweep.exact(fall(n));
    int now = time.nearest() == 0 ? Contact.NOW : 0;
    return FallSweep.contact(exact.region(time), exact.side(time)) | now;
  }

  /** The exact time of an impact. */
  public static RealRoot root(double time, double... n) {
    return FallSweep.exact(fall(n)).at(time);
  }
}
