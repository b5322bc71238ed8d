// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class AcceptanceLimitsTest {

  private static List<String> row(Sample sample, String what, String where) {
    return AcceptanceLimits.table(sample.results()).rows().stream()
        .filter(row -> row.get(0).startsWith(what) && row.get(1).equals(where))
        .findFirst()
        .orElseThrow();
  }

  private static String sentence(Sample sample) {
    return AcceptanceLimits.sentence(sample.results());
  }

  @Test
  void eachLimitStandsBesideWhatWasMeasured() {
    Sample sample = Sample.complete();
    assertThat(row(sample, "wrong answers", "all questions"))
        .endsWith("0", "0 of 30,000 (below 0.01 % at 95 %)", "yes");
    assertThat(row(sample, "worst error of one frame, in radii", "base-1"))
        .endsWith("1.0e-12", "3.0e-16", "yes");
    assertThat(row(sample, "slowest frame", "fast-1")).endsWith("16.7 ms", "3.12 µs", "yes");
    assertThat(row(sample, "both faster", "base-1")).endsWith("none", "none", "yes");
  }

  @Test
  void whatWasNotMeasuredIsLeftOut() {
    assertThat(AcceptanceLimits.table(Sample.complete().results()).rows())
        .extracting(row -> row.get(1))
        .contains("base-1", "fast-1")
        .doesNotContain("radii", "base-1-r5");
  }

  @Test
  void aLimitIsMissedByTheLeastExcess() {
    Sample sample = Sample.complete();
    sample.add("fast-1", "carom", "", "frame_roundings", "max", 4, "1", -1);
    assertThat(row(sample, "worst error", "fast-1")).endsWith("4", "4", "yes");
    Sample more = Sample.complete();
    more.add("fast-1", "carom", "", "frame_roundings", "max", 4.01, "1", -1);
    assertThat(row(more, "worst error", "fast-1").get(4)).isEqualTo("no");
    assertThat(sentence(more))
        .startsWith(
            "Limits: 7 of the 8 that were measured hold; missed: worst error of one circle in one frame")
        .endsWith(", fast-1: 4.01 (limit: 4).");
  }

  @Test
  void howManyAreAboveIsTold() {
    Sample sample = Sample.complete();
    sample.add("fast-1", "carom", "", "frame_roundings", "max", 8.4, "1", -1);
    sample.add("fast-1", "carom", "", "frame_roundings", "above limit", 3, "1", -1);
    sample.add("fast-1", "carom", "", "frame_roundings", "max of frames", 1.2, "1", -1);
    assertThat(row(sample, "worst error", "fast-1"))
        .endsWith("4", "8.4, 3 of 600 circle-frames above", "no");
    assertThat(row(sample, "worst error of one frame, in 2^-53", "fast-1"))
        .endsWith("4", "1.2", "yes");
    assertThat(Report.summary(sample.results())).contains("circle-frames above (limit: 4)");
  }

  @Test
  void whoIsBetterInBothIsNamed() {
    Sample sample = Sample.complete().frames("fast-1", "better", "k=2", 500, 1e-17, 0);
    assertThat(row(sample, "both faster", "fast-1"))
        .endsWith("none", "better (k=2) in fast-1", "no");
  }

  @Test
  void fewForksAreTooFew() {
    Sample sample = Sample.complete().without(row -> row.fork() == 4);
    assertThat(row(sample, "forks", "all times but of growth")).endsWith("at least 5", "4", "no");
  }

  @Test
  void circlesThatAreOutsideAreCounted() {
    Sample sample = Sample.complete();
    sample.add("base-1", "carom", "", "escaped", "circles", 0, "1", -1);
    assertThat(row(sample, "circles", "base-1")).endsWith("0", "0", "yes");
    sample.add("base-1", "carom", "", "outside_at_end", "circles", 1, "1", -1);
    assertThat(row(sample, "circles", "base-1")).endsWith("0", "1", "no");
  }
}
