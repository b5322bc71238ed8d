// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static dev.carom.bench.measures.Found.value;
import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.methods.Methods;
import dev.carom.bench.results.Row;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** On the experiment itself, against its true course. */
class ScenePartTest {

  @Test
  void aFrameOfCaromIsRightToTheLastPlaces() {
    List<Row> rows = new ScenePart("base-1", Methods.CAROM).run();

    // Coordinates of up to 800 are known to 2^-44 px, radii are 10.
    assertThat(value(rows, "frame_error", "max")).isPositive().isLessThan(1e-13);
    assertThat(value(rows, "tunnelled", "circles")).isZero();
    assertThat(value(rows, "escaped", "circles")).isZero();
    assertThat(rows).allSatisfy(row -> assertThat(row.scene()).isEqualTo("base-1"));
  }

  /** With circles that can reach the sides of the crosses; its true course is computed. */
  @Test
  void aFrameWithSmallCirclesIsRightToo() {
    List<Row> rows = new ScenePart(Subjects.SMALL, Methods.CAROM).run();

    assertThat(value(rows, "frame_error", "max")).isPositive().isLessThan(2e-13);
    assertThat(value(rows, "horizon", "any")).isGreaterThan(100);
  }

  @Test
  void theOverlapTestIsLostWithItsFirstImpact() {
    List<Row> rows = new ScenePart("base-1", Methods.OVERLAP).run();

    assertThat(value(rows, "frame_error", "max")).isGreaterThan(0.1);
    assertThat(value(rows, "horizon", "any")).isLessThan(10);
  }

  /** The last bit of the start matters after some dozens of frames, and not before. */
  @Test
  void noDoubleCanStayLongWithTheTruth() {
    List<Row> rows = new UlpPart("base-1").run();

    assertThat(value(rows, "horizon", "any")).isBetween(40.0, 200.0);
    assertThat(value(rows, "horizon", "median")).isBetween(200.0, 400.0);
    assertThat(rows).allSatisfy(row -> assertThat(row.method()).isEqualTo("reference+1ulp"));
  }

  @Test
  void aSceneWithoutAReferenceTellsTheRest() {
    Subject subject = new Subject("unknown", Subjects.scene("base-2"), 20, Optional.empty());
    Trial trial = new Trial("unknown", Methods.CAROM);

    List<Row> rows = ScenePart.measure(trial, subject);

    assertThat(rows).extracting(Row::metric).contains("penetration").doesNotContain("horizon");
    assertThat(value(rows, "impacts", "mean")).isPositive();
  }
}
