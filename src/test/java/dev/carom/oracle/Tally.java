// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.Locale;

/** Counts over some queries. */
public final class Tally {
  /** The head of the table whose rows are {@link #row}. */
  public static final String HEAD =
      String.format(
          "%-22s %10s %10s %6s %6s %10s %7s %7s %9s  %s",
          "family",
          "queries",
          "hits",
          "wrong",
          ">1ulp",
          "unrounded",
          "worst",
          ">1e-15",
          "worst",
          "failures");

  long queries;
  long hits;
  long wrongDecisions;
  long beyondOneUlp;
  long notNearest;
  long badNormals;
  double worstUlps;
  double worstNormal;
  String firstFailure;

  /** Keeps the first description of a failure. */
  void note(String failure) {
    firstFailure = firstFailure == null ? failure : firstFailure;
  }

  /** The sum of two counts, in a new one. */
  public Tally plus(Tally other) {
    Tally sum = new Tally();
    sum.queries = queries + other.queries;
    sum.hits = hits + other.hits;
    sum.wrongDecisions = wrongDecisions + other.wrongDecisions;
    sum.beyondOneUlp = beyondOneUlp + other.beyondOneUlp;
    sum.notNearest = notNearest + other.notNearest;
    sum.badNormals = badNormals + other.badNormals;
    sum.worstUlps = Math.max(worstUlps, other.worstUlps);
    sum.worstNormal = Math.max(worstNormal, other.worstNormal);
    sum.firstFailure = firstFailure != null ? firstFailure : other.firstFailure;
    return sum;
  }

  /** Wrong decisions, times beyond 1 ulp and normals beyond 1e-15. */
  public long failures() {
    return wrongDecisions + beyondOneUlp + badNormals;
  }

  public long wrongDecisions() {
    return wrongDecisions;
  }

  public long beyondOneUlp() {
    return beyondOneUlp;
  }

  /** Times within 1 ulp or not, that are not the correctly rounded ones. */
  public long notNearest() {
    return notNearest;
  }

  /** The first failure with all its inputs, null if there was none. */
  public String firstFailure() {
    return firstFailure;
  }

  /**
   * One row of the table. With no failure in n independent queries the rate of failures is below
   * 3/n at 95 % confidence: (1 - 3/n)^n = e^-3 = 5 %.
   */
  public String row(String name) {
    String verdict =
        failures() > 0
            ? String.valueOf(failures())
            : String.format(Locale.ROOT, "0 of %d, below %.1e at 95 %%", queries, 3.0 / queries);
    return String.format(
        Locale.ROOT,
        "%-22s %10d %10d %6d %6d %10d %7.4g %7d %9.1e  %s",
        name,
        queries,
        hits,
        wrongDecisions,
        beyondOneUlp,
        notNearest,
        worstUlps,
        badNormals,
        worstNormal,
        verdict);
  }
}
