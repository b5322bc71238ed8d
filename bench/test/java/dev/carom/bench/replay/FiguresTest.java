// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FiguresTest {

  private static final Counts COUNTS = new Counts(1850, 800, 1800);

  /** Frames of 1, 2, .. n microseconds. */
  private static long[] ramp(int n) {
    return LongStream.rangeClosed(1, n).map(us -> 1000 * us).toArray();
  }

  private static long[] constant(int n, long nanos) {
    long[] times = new long[n];
    Arrays.fill(times, nanos);
    return times;
  }

  private static Samples fork(long[] cold, long[]... replays) {
    return new Samples(cold, List.of(replays), 25, 600);
  }

  @Test
  void quantilesAreOverAllSamplesOfAllForks() {
    Figures figures =
        Figures.of(
            "carom", COUNTS, List.of(fork(ramp(100), ramp(100)), fork(ramp(100), ramp(100))));

    assertThat(figures.samples()).isEqualTo(200);
    assertThat(figures.mean()).isEqualTo(50.5);
    assertThat(figures.median()).isEqualTo(50);
    assertThat(figures.p95()).isEqualTo(95);
    assertThat(figures.p99()).isEqualTo(99);
    assertThat(figures.fps()).isEqualTo(1e6 / 50.5);
  }

  @Test
  void oneOutlierMovesTheWorstOfAllAndNotTheWorstOfAReplay() {
    long[] disturbed = ramp(100);
    disturbed[7] = 20_000_000;
    Figures figures =
        Figures.of("carom", COUNTS, List.of(fork(ramp(60), ramp(100), disturbed, ramp(100))));

    assertThat(figures.worst()).isEqualTo(100);
    assertThat(figures.worstOfAll()).isEqualTo(20_000);
    assertThat(figures.framesOverBudget()).isEqualTo(1);
  }

  @Test
  void theBudgetItselfIsNotOverTheBudget() {
    long[] atBudget = constant(3, 16_666_666);
    long[] over = constant(3, 16_666_667);
    Figures figures = Figures.of("carom", COUNTS, List.of(fork(over, atBudget, over)));

    assertThat(figures.framesOverBudget()).isEqualTo(3);
    assertThat(figures.shareOfBudget()).isBetween(0.9999, 1.0001);
  }

  @Test
  void aColdStartIsItsFirstSixtyFrames() {
    long[] cold = IntStream.range(0, 600).mapToLong(f -> f < 60 ? 5000 : 9_000_000).toArray();
    Figures figures = Figures.of("carom", COUNTS, List.of(fork(cold, ramp(600))));

    assertThat(figures.coldMean()).isEqualTo(5);
    assertThat(figures.coldWorst()).isEqualTo(5);
    assertThat(figures.bytesPerFrame()).isEqualTo(1);
  }

  @Test
  void forksAreToldApart() {
    Figures figures =
        Figures.of(
            "carom",
            COUNTS,
            List.of(
                fork(ramp(60), constant(100, 3000)),
                fork(ramp(60), constant(100, 1000)),
                fork(ramp(60), constant(100, 2000))));

    assertThat(figures.leastForkMean()).isEqualTo(1);
    assertThat(figures.mostForkMean()).isEqualTo(3);
  }

  @Test
  void samplesComeBackFromTheirFile(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("fork.samples");
    fork(ramp(5), ramp(3), constant(3, Long.MAX_VALUE)).write(file);

    Samples samples = Samples.read(file);

    assertThat(samples.cold()).isEqualTo(ramp(5));
    assertThat(samples.replays()).hasSize(2);
    assertThat(samples.replays().get(0)).isEqualTo(ramp(3));
    assertThat(samples.replays().get(1)).isEqualTo(constant(3, Long.MAX_VALUE));
    assertThat(samples.emptyPairNanos()).isEqualTo(25);
    assertThat(samples.bytesAllocated()).isEqualTo(600);
  }
}
