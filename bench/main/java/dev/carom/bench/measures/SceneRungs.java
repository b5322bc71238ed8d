// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.methods.RungCounts;
import dev.carom.bench.results.Row;
import java.util.List;
import java.util.Locale;

/**
 * How often a scene needed more precision.
 *
 * @param scene its name in result files
 * @param counts of all its frames
 */
public record SceneRungs(String scene, RungCounts counts) {

  /**
   * Renders counts for people: one row a scene.
   *
   * @param scenes the counts of each
   * @return the table
   */
  public static String render(List<SceneRungs> scenes) {
    StringBuilder text = new StringBuilder();
    text.append(row("", "pairs", "open in", "exact", "exact", "falls", "exact"));
    text.append(row("scene", "tested", "doubles", "decisions", "times", "asked", "falls"));
    for (SceneRungs s : scenes) {
      RungCounts c = s.counts;
      text.append(
          row(
              s.scene,
              c.pairTests(),
              c.doubtfulDecisions(),
              c.exactDecisions(),
              c.exactTimes(),
              c.falls(),
              c.exactFalls()));
    }
    return text.toString();
  }

  private static String row(Object... cells) {
    return String.format(Locale.ROOT, "%-24s %9s %9s %9s %9s %9s %9s%n", cells);
  }

  /** As rows: the counts, by their names. */
  public List<Row> rows() {
    return List.of(
        row("rungs", "asked", counts.pairTests()),
        row("rungs", "doubtful", counts.doubtfulDecisions()),
        row("rungs", "exact", counts.exactDecisions()),
        row("rungs_of_times", "exact", counts.exactTimes()),
        row("rungs_of_falls", "asked", counts.falls()),
        row("rungs_of_falls", "exact", counts.exactFalls()));
  }

  private Row row(String metric, String stat, long count) {
    return new Row(scene, "carom", "", metric, stat, (double) count, "1", 1, -1);
  }
}
