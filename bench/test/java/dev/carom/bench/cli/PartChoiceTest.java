// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import dev.carom.bench.measures.Part;
import dev.carom.bench.measures.Parts;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.SeriesParts;
import dev.carom.bench.stability.StabilityPart;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class PartChoiceTest {

  private record Named(String id) implements Part {
    @Override
    public double seconds() {
      return 1;
    }

    @Override
    public List<Row> run() {
      return List.of();
    }
  }

  private static final List<Part> ALL =
      List.of(
          new Named("scene/base-1/carom"),
          new Named("scene/base-2/carom"),
          new Named("query/grazing"),
          new Named("query-time/fork-0"),
          new Named("time/base-1/fork-0"),
          SeriesParts.sweep(0, true),
          SeriesParts.scale(0, true),
          SeriesParts.features(0, true),
          SeriesParts.worlds(true),
          StabilityPart.all(true).get(0));

  @Test
  void whatIsUntimedTakesNoTimes() {
    assertThat(PartChoice.untimed(ALL))
        .extracting(Part::id)
        .containsExactly(
            "scene/base-1/carom", "scene/base-2/carom", "query/grazing", "stability/angle");
  }

  @Test
  void aShortRunPlaysTheScenesThatItIsAskedFor() {
    assertThat(Parts.of(true, List.of("base-2", "radii")))
        .extracting(Part::id)
        .contains("scene/base-2/carom", "scene/radii/carom", "time/radii/fork-0", "time/gas/fork-4")
        .noneMatch(id -> id.contains("base-1"))
        .contains("query/grazing", "query-time/fork-0", "gas/gas/carom", "rungs/all");
  }

  @Test
  void aSceneThatThereIsNotIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Parts.of(true, List.of("base-1", "base-7")))
        .withMessage(
            "--scenes has base-7: expected base-1, base-1-r5, fast-1, radii, base-2, base-3");
  }

  @Test
  void everyRealPartIsOfAKnownKind() {
    List<Part> all = new ArrayList<>(Parts.of(false));
    assertThat(all)
        .extracting(Part::id)
        .allMatch(
            id ->
                id.matches(
                    "(scene/.+|gas/.+|heap/.+|bounce/.+|rungs|query|query-time|time/.+)/[^/]+"));
    assertThat(PartChoice.untimed(all)).hasSizeBetween(100, all.size() - 20);
  }

  /** In seconds; the sweep comes on top of it. */
  @Test
  void theEstimatesOfBothRunsAreWithinTheirLimits() {
    assertThat(Parts.of(true).stream().mapToDouble(Part::seconds).sum()).isBetween(60.0, 500.0);
    assertThat(Parts.of(false).stream().mapToDouble(Part::seconds).sum()).isBetween(600.0, 2600.0);
  }
}
