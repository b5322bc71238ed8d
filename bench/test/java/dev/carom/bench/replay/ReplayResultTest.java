// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.results.Row;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class ReplayResultTest {

  private static final Machine MACHINE = new Machine("a processor, 2 cores", "a jdk", "-Xmx1g");

  private ReplayResult result;

  @BeforeEach
  void makeUp() throws CannotPlaceException {
    result = result(2_000, 100_000);
  }

  private static ReplayResult result(long carom, long poster) throws CannotPlaceException {
    Crosses crosses = Crosses.canonical(1);
    ReplayPlan plan = new ReplayPlan("a scene", crosses.scene(), List.of(), 3, 1, 0);
    return new ReplayResult(
        plan, Map.of(Methods.CAROM, samples(carom), Methods.POSTER, samples(poster)), MACHINE);
  }

  private static List<Samples> samples(long nanos) {
    long[] slow = {nanos, nanos, 3 * nanos};
    long[] times = {nanos, nanos, nanos};
    long[] fast = {nanos, nanos, nanos / 2};
    return List.of(new Samples(slow, List.of(slow, times, fast), 25, 0));
  }

  @Test
  void itsRowsAreTheFiguresOfEachMethod() {
    assertThat(result.rows())
        .hasSize(18)
        .contains(
            new Row(result.plan().name(), "carom", "", "frame_time", "median", 2_000, "ns", 9, -1))
        .extracting(Row::method)
        .containsOnly("carom", "poster");
  }

  @Test
  void theTableSaysAtAGlanceWhetherTheBudgetIsMet() throws CannotPlaceException {
    assertThat(ReplayTable.render(result))
        .contains("BUDGET MET: the slowest frame of a replay takes 2.00 us of the 16,667 us")
        .contains("50.0 times as fast as poster")
        .contains("52,083");
    assertThat(ReplayTable.render(result(18_000_000, 100_000_000)))
        .contains("BUDGET MISSED: the slowest frame of a replay takes 18,000 us")
        .contains("8 of all 9 frames exceeded them.");
  }

  /** The published algorithm knows no collisions: this library replays alone. */
  @Test
  void whereCirclesCollideThereIsNoRatio() {
    Scene scene = Scene.builder().circle(0, 0, 1, 1, 0).circle(5, 0, 1, -1, 0).build();
    ReplayPlan plan = new ReplayPlan("a pair", scene, List.of(), 3, 1, 0);
    ReplayResult pair = new ReplayResult(plan, Map.of(Methods.CAROM, samples(2_000)), MACHINE);

    assertThat(pair.ratioToPoster()).isEmpty();
    assertThat(ReplayTable.render(pair))
        .contains("BUDGET MET")
        .contains("it does not replay this scene.")
        .containsPattern("impacts with lines, pegs and circles +1\n")
        .doesNotContain("poster");
  }

  @Test
  void thePublishedAlgorithmReplaysWhatItKnows() {
    Scene straight = Scene.builder().line(0, 0, 9, 0).circle(5, 9, 1, 1, 0).build();
    Scene falling = Scene.builder().gravity(0, 1).circle(5, 9, 1, 1, 0).build();
    Scene lift = Scene.builder().line(0, 0, 9, 0).velocity(0, 1).circle(5, 9, 1, 1, 0).build();

    assertThat(new ReplayPlan("straight", straight, List.of(), 3, 1, 0).contenders())
        .containsExactly(Methods.CAROM, Methods.POSTER);
    for (Scene scene : List.of(falling, lift)) {
      assertThat(new ReplayPlan("other", scene, List.of(), 3, 1, 0).contenders())
          .containsExactly(Methods.CAROM);
    }
  }

  @Test
  void theTableIsAligned() {
    String table = ReplayTable.render(result);

    List<String> rows =
        table.lines().filter(row -> row.matches("(mean|median|p99|worst).*")).toList();
    assertThat(rows).hasSize(5);
    assertThat(rows.subList(1, 5)).allSatisfy(row -> assertThat(row).hasSize(70));
    assertThat(table.lines())
        .allSatisfy(line -> assertThat(line.length()).isLessThanOrEqualTo(100));
  }

  @Test
  void theTypicalReplayIsTheMedianOne() {
    assertThat(Arrays.stream(result.typicalReplay()).max()).hasValue(2000);
  }
}
