// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.PatchedDetector.Reply;
import dev.carom.oracle.Query;
import java.util.Locale;

/**
 * How much of a bound is needed: the least of the factors 0, 2^-12, 2^-11, ... 1/2, 1 with which no
 * query so far is answered wrongly. A smaller bound leaves fewer queries open and so makes the same
 * mistakes and more; therefore a query that asks for more moves the factor up, and never down.
 */
final class Slack {
  static final String HEAD =
      String.format(
          "%-24s %10s %9s %7s  %s",
          "bound", "value", "queries", "needed", "first mistake without it");

  private static final int LEAST_EXPONENT = -12;

  private final RoundingBound bound;
  private PatchedDetector detector;
  private double factor;
  private long queries;
  private String family = "-";
  private Query witness;
  private Reply mistake;

  Slack(RoundingBound bound) {
    this.bound = bound;
    this.detector = PatchedDetector.scaled(bound, 0);
  }

  /** Asks a query whose answer is known; whether the whole bound, and more, would be needed. */
  boolean isViolatedBy(String name, Query query, Reply truth) {
    queries++;
    Reply reply = detector.ask(query);
    while (!reply.equals(truth)) {
      if (witness == null) {
        family = name;
        witness = query;
        mistake = reply;
      }
      if (factor == 1) {
        return true;
      }
      factor = bound.isBound() && factor > 0 ? 2 * factor : first();
      detector = PatchedDetector.scaled(bound, factor);
      reply = detector.ask(query);
    }
    return false;
  }

  private double first() {
    return bound.isBound() ? Math.scalb(1.0, LEAST_EXPONENT) : 1;
  }

  RoundingBound bound() {
    return bound;
  }

  /** The first query that is answered wrongly without the bound, null if there was none. */
  Query witness() {
    return witness;
  }

  /** The wrong answer to the witness. */
  Reply mistake() {
    return mistake;
  }

  String row() {
    String needed = bound.isBound() && factor > 0 ? "2^" + Math.getExponent(factor) : "-";
    String first = witness == null ? "none" : family + ": " + mistake.part() + " " + mistake.time();
    return String.format(
        Locale.ROOT, "%-24s %10s %9d %7s  %s", bound, bound.inUnits(), queries, needed, first);
  }
}
