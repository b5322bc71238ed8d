// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class VerdictTest {

  private static List<String> verdict(Sample sample) {
    return Verdict.of(sample.results());
  }

  @Test
  void tellsSixThingsEachWithItsNumber() {
    assertThat(verdict(Sample.complete()))
        .containsExactly(
            "Decisions: wrong answers of Carom: 0 of 30,000 (below 0.01 % at 95 %); next is"
                + " textbook double, with 99.",
            "Accuracy: in 2 scenes the worst error of one frame of Carom is 3.0e-16 radii; next is"
                + " exact, with 4.0e-16.",
            "Budget: met; the slowest frame of Carom in 2 scenes takes 3.12 µs (base-1, median over"
                + " forks), 1/5,342 of the 16.67 ms of 60 FPS.",
            "Place: in 2 scenes nothing measured is both faster and more accurate than Carom; in 2"
                + " of 2 it is itself faster and more accurate than all others.",
            "Growth: not measured.",
            "Limits: 7 of the 7 that were measured hold.");
  }

  @Test
  void tellsOfWrongAnswersAndOfWhoHasFewer() {
    Sample sample = Sample.complete().without(row -> row.scene().startsWith("query:"));
    sample.query("grazing", "carom", "", 30, 0.5, 3, 1).query("grazing", "other", "", 9, 1, 2, 0);
    assertThat(verdict(sample).get(0))
        .isEqualTo("Decisions: wrong answers of Carom: 4 of 10,000; fewer has other, with 2.");
  }

  @Test
  void doesNotPraiseWhatOthersDoAsWell() {
    Sample sample = Sample.complete().without(row -> row.scene().startsWith("query:"));
    sample.query("grazing", "carom", "", 30, 0.5, 0, 0).query("grazing", "other", "", 9, 1, 0, 0);
    assertThat(verdict(sample).get(0)).endsWith("; as many has other, with 0.");
  }

  @Test
  void namesWhoIsMoreAccurate() {
    Sample sample = Sample.complete();
    for (String scene : List.of("base-1", "fast-1")) {
      sample.frames(scene, "slow", "", 1e6, 1e-17, 0);
    }
    assertThat(verdict(sample).get(1)).endsWith("; more accurate is slow, with 1.0e-17.");
    assertThat(verdict(sample).get(3)).contains("nothing measured is both");
  }

  @Test
  void namesWhoIsBothFasterAndMoreAccurateAnywhere() {
    Sample sample = Sample.complete().frames("fast-1", "better", "k=2", 500, 1e-17, 0);
    assertThat(verdict(sample).get(3))
        .isEqualTo(
            "Place: Carom is beaten: both faster and more accurate is better (k=2) in fast-1.");
  }

  @Test
  void namesNoWinnerWhereTimesOverlap() {
    Sample sample = Sample.complete().frames("fast-1", "close", "", 980, 1e-17, 0);
    assertThat(verdict(sample).get(3))
        .contains("nothing measured is both faster", "in 1 of 2 it is itself")
        .endsWith("more accurate, and not told apart in time: close in fast-1.");
  }

  @Test
  void aSceneWithoutTimesIsNoPlaceToBeFast() {
    Sample sample = Sample.complete().frames("base-9", "carom", "", 1000, 1e-16, 9);
    sample.without(row -> row.scene().equals("base-9") && row.metric().equals("frame_time"));
    assertThat(verdict(sample).get(1)).startsWith("Accuracy: in 3 scenes");
    assertThat(verdict(sample).get(3)).startsWith("Place: in 2 scenes");
  }

  @Test
  void saysWhenTheBudgetIsMissed() {
    Sample sample =
        Sample.complete()
            .without(row -> row.method().equals("carom") && row.metric().equals("frame_time"));
    assertThat(verdict(sample).get(2)).isEqualTo("Budget: not measured.");
    sample.frames("base-2", "carom", "", 1e7, 1e-16, 9);
    assertThat(verdict(sample).get(2))
        .startsWith("Budget: missed; the slowest frame of Carom in 1 scene takes 31.2 ms (base-2")
        .endsWith(", 1.87 times of the 16.67 ms of 60 FPS.");
  }

  @Test
  void shortcomingsNameMethodsAndScenes() {
    assertThat(Verdict.shortcomings(Sample.complete().results())).isEmpty();
    Sample sample = Sample.complete().frames("fast-1", "peer", "k=2", 500, 3e-16, 0);
    assertThat(Verdict.shortcomings(sample.results()))
        .containsExactly(
            "Faster than Carom: peer (k=2) in fast-1.",
            "As accurate as Carom: peer (k=2) in fast-1.");
  }

  @Test
  void aFailureOfOursIsTold() {
    Sample sample =
        Sample.complete()
            .without(row -> row.method().equals("carom") && row.scene().equals("fast-1"))
            .frames("fast-1", "carom", "", 1000, Double.NaN, 0);
    assertThat(verdict(sample).get(1)).endsWith("it failed in a scene.");
    assertThat(verdict(sample).get(3)).contains("in 1 of 2 it is itself");
  }

  @Test
  void whatWasNotMeasuredIsNotJudged() {
    assertThat(verdict(new Sample()))
        .containsExactly(
            "Decisions: not measured.",
            "Accuracy: Carom has no error to show: not measured.",
            "Budget: not measured.",
            "Place: not measured.",
            "Growth: not measured.",
            "Limits: not measured.");
  }
}
