// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import java.util.Locale;

/** Which precision decided, by class of questions and by scene. */
final class RungShares {

  private static final String QUERY = "query:";

  private final Results results;

  RungShares(Results results) {
    this.results = results;
  }

  private double count(String scene, String stat) {
    return results.value(scene, Metrics.CAROM, Metrics.RUNGS, stat);
  }

  /** The share of each precision; no row if it was not measured. */
  ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder("asked", "doubles", "double-double", "exact numbers");
    for (String scene : results.scenes(Metrics.RUNGS)) {
      double asked = count(scene, "asked");
      if (asked > 0) {
        table.row(
            scene.startsWith(QUERY)
                ? "questions: " + Metrics.queryClass(scene)
                : "pairs looked at in " + scene,
            percent(count(scene, "double") / asked),
            percent(count(scene, "double-double") / asked),
            percent(count(scene, "exact") / asked));
      }
    }
    return table.build();
  }

  /** Not 100 % unless it is all, nor 0 unless it is none. */
  private static String percent(double share) {
    if (share == 1 || share == 0) {
      return share == 1 ? "100 %" : "0 %";
    }
    int digits = share > 0.999 || share < 0.001 ? 4 : 1;
    double unit = Math.pow(10, -digits);
    return String.format(
        Locale.ROOT, "%." + digits + "f %%", Math.min(100 - unit, Math.max(unit, 100 * share)));
  }

  /** The shares over the frames of all scenes, which are what a user sees. */
  String sentence() {
    double asked = 0;
    double doubles = 0;
    for (String scene : results.scenes(Metrics.RUNGS)) {
      if (!scene.startsWith(QUERY)) {
        asked += count(scene, "asked");
        doubles += count(scene, "double");
      }
    }
    return asked == 0
        ? "Precision was not measured."
        : "Of %s pairs of circle and line that frames looked at, plain doubles decided %s."
            .formatted(
                ReportNumbers.count(asked),
                doubles == asked ? "all" : "all but " + ReportNumbers.count(asked - doubles));
  }
}
