// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.jmh;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Kind;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;

class BenchmarksTest {

  /** A benchmark of a query that is answered otherwise than its name says measures nothing. */
  @Test
  void queriesAreWhatTheirNamesSay() {
    QueryBenchmark queries = new QueryBenchmark();
    int hits = 0;
    int grazes = 0;
    for (int i = 0; i < 4096; i++) {
      assertThat(queries.lineSide()).isBetween(0.0, 1.0);
      assertThat(queries.lineMiss()).isInfinite();
      assertThat(queries.lineNearMiss()).isInfinite();
      assertThat(queries.pegMiss()).isInfinite();
      assertThat(queries.pairMiss()).isInfinite();
      grazes += Double.isFinite(queries.lineGraze()) ? 1 : 0;
      assertThat(queries.peg()).isBetween(0.0, 1.0);
      assertThat(queries.pair()).isBetween(0.0, 1.0);
      assertThat(queries.sphere()).isBetween(0.0, 1.0);
      assertThat(queries.bounds()).isBetween(0.0, 1.0);
      hits += Double.isFinite(queries.lineEndpoint()) ? 1 : 0;
    }
    assertThat(hits).isGreaterThan(4000);
    assertThat(grazes).isBetween(1000, 3000); // rounding decides
  }

  @Test
  void everyBenchmarkRuns() throws Exception {
    long benchmarks =
        Stream.of(
                EditBenchmark.class,
                GasBenchmark.class,
                GrowthBenchmark.class,
                QueryBenchmark.class,
                QuestionBenchmark.class)
            .flatMap(type -> Stream.of(type.getDeclaredMethods()))
            .filter(method -> method.isAnnotationPresent(Benchmark.class))
            .count();
    Options once =
        new OptionsBuilder()
            .include("dev\\.carom\\.bench\\.jmh\\.")
            .forks(0)
            .warmupIterations(0)
            .measurementIterations(1)
            .mode(Mode.SingleShotTime)
            .param("circles", "100")
            .param("lines", "100")
            .param("pegs", "2")
            .param("queries", "4096")
            .verbosity(VerboseMode.SILENT)
            .shouldFailOnError(true)
            .build();
    assertThat(new Runner(once).run()).hasSize(Math.toIntExact(benchmarks));
  }

  @Test
  void aGasHasEvents() throws Exception {
    GasBenchmark gas = new GasBenchmark();
    gas.circles = 100;
    gas.generate();
    gas.start();
    GasBenchmark.Count count = new GasBenchmark.Count();
    for (int i = 0; i < 100; i++) {
      gas.frame(count);
    }
    assertThat(count.events).isPositive();
  }

  @Test
  void growthIsOfAsManyCirclesAsAsked() throws Exception {
    GrowthBenchmark growth = new GrowthBenchmark();
    for (int circles : new int[] {1, 10, 100, 400}) {
      growth.circles = circles;
      growth.generate();
      assertThat(growth.build().count(Kind.CIRCLE)).isEqualTo(circles);
    }
  }

  @Test
  void editsAreWhatTheirNamesSay() throws Exception {
    EditBenchmark edits = new EditBenchmark();
    EditBenchmark.Steered steered = new EditBenchmark.Steered();
    steered.start(2);
    for (int i = 0; i < 20; i++) {
      edits.steer(steered);
    }
    edits.steerOne(steered);
    assertThat(edits.setVelocity(steered).count(Kind.CIRCLE)).isEqualTo(400);
    assertThat(steered.world.idLimit(Kind.LINE)).isEqualTo(400);
    assertThat(steered.world.impacts().size()).isPositive();

    EditBenchmark.Thousand thousand = new EditBenchmark.Thousand();
    thousand.start();
    edits.restoreAndStepAlone(thousand);
    edits.restoreAndStepGas(thousand);
    assertThat(edits.snapshotAlone(thousand)).isNotEqualTo(thousand.ofAlone);
    assertThat(edits.restoreAlone(thousand).snapshot()).isEqualTo(thousand.ofAlone);
    assertThat(edits.restoreGas(thousand).count(Kind.CIRCLE)).isEqualTo(1000);
    assertThat(edits.snapshotGas(thousand)).isEqualTo(thousand.ofGas);
    assertThat(edits.hashGas(thousand)).isEqualTo(thousand.ofGas.hash64());
    assertThat(edits.writeGas(thousand)).isEqualTo(thousand.bytesOfGas).hasSize(105_151);
    assertThat(edits.readGas(thousand)).isEqualTo(thousand.ofGas);
    assertThat(edits.pastGas(thousand).now()).isZero();
    assertThat(edits.pastGas(thousand).now()).isEqualTo(EditBenchmark.PAST / EditBenchmark.MOMENTS);
  }

  @Test
  void aTimelineIsAskedForWhatItHolds() throws Exception {
    EditBenchmark edits = new EditBenchmark();
    EditBenchmark.Recorded recorded = new EditBenchmark.Recorded();
    recorded.record();
    assertThat(edits.lookUp(recorded)).isBetween(0.0, 100 * 1400.0);
    assertThat(edits.lookUp(recorded)).isNotEqualTo(edits.lookUp(recorded));
    assertThat(recorded.timeline.end()).isEqualTo(600);
    edits.frame(recorded);
    edits.frameRecorded(recorded);
    assertThat(recorded.recording.snapshot()).isEqualTo(recorded.plain.snapshot());
  }
}
