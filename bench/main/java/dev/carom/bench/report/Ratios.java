// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** How many times as long as Carom each method and peer takes for a frame. */
public final class Ratios {

  private Ratios() {}

  /** Most of its frames come after all is at rest, so its median says nothing of the fall. */
  private static final String HEAP = "heap";

  /**
   * The ratios of the medians, of a heap those of the means, in brackets the least and the greatest
   * that the forks allow.
   *
   * @param results what was measured
   * @return a row for each setting, a column for each scene
   */
  public static ReportTable of(Results results) {
    List<String> scenes =
        results.scenes(Metrics.FRAME_TIME).stream()
            .filter(s -> results.settings(s, Metrics.FRAME_TIME).contains(Metrics.CAROM))
            .toList();
    List<String> head = new ArrayList<>(List.of("time of a frame, Carom = 1"));
    scenes.forEach(scene -> head.add(scene.equals(HEAP) ? HEAP + ", means" : scene));
    ReportTable.Builder table = new ReportTable.Builder(head);
    List<Setting> settings =
        Settings.sorted(
            scenes.stream()
                .flatMap(scene -> results.settings(scene, Metrics.FRAME_TIME).stream())
                .distinct()
                .filter(setting -> !setting.equals(Metrics.CAROM))
                .toList());
    for (Setting setting : settings) {
      List<String> cells = new ArrayList<>(List.of(Metrics.fullName(setting)));
      scenes.forEach(scene -> cells.add(ratio(results, scene, setting)));
      table.row(cells);
    }
    return table.build();
  }

  private static String ratio(Results results, String scene, Setting setting) {
    String stat = scene.equals(HEAP) ? "mean" : "median";
    Optional<Spread> theirs = results.spread(scene, setting, Metrics.FRAME_TIME, stat);
    Spread ours = results.spread(scene, Metrics.CAROM, Metrics.FRAME_TIME, stat).orElseThrow();
    if (theirs.isEmpty() || theirs.get().failed() || ours.failed()) {
      return theirs.isEmpty() ? "not measured" : "failed";
    }
    Spread t = theirs.get();
    String middle = ReportNumbers.ratio(t.middle() / ours.middle());
    if (t.forks() < 2) {
      return middle;
    }
    return "%s (%s .. %s)"
        .formatted(
            middle,
            ReportNumbers.ratio(t.low() / ours.high()),
            ReportNumbers.ratio(t.high() / ours.low()));
  }
}
