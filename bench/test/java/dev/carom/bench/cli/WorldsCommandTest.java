// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.report.SeriesTables;
import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsJson;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.ManyWorlds;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WorldsCommandTest {

  @Test
  void tellsSpeedsAndTheHashThatAllShare(@TempDir Path folder) throws IOException {
    Path json = folder.resolve("worlds.json");
    Cli run = Cli.run("measure worlds --worlds 40 --threads 3 --rounds 2 --json", json);

    assertThat(run.exitCode()).as(run.err()).isZero();
    assertThat(run.out()).contains("one thread", "2 threads", "3 threads");
    Results results = ResultsJson.read(json);
    assertThat(results.rows())
        .filteredOn(row -> row.metric().equals(ManyWorlds.SPEED))
        .hasSize(9)
        .allMatch(row -> row.value() > 0 && row.n() == 40);
    assertThat(results.rows())
        .filteredOn(row -> row.metric().equals(ManyWorlds.MEMORY))
        .singleElement()
        .satisfies(row -> assertThat(row.value()).isBetween(10_000.0, 60_000.0));
    Cli again = Cli.run("measure worlds --worlds 40 --threads 1 --rounds 1");
    assertThat(hash(again.out())).isEqualTo(hash(run.out()));
    assertThat(hash(Cli.run("measure worlds --worlds 41 --threads 1 --rounds 1").out()))
        .isNotEqualTo(hash(run.out()));
  }

  private static String hash(String out) {
    return out.lines().filter(line -> line.startsWith("hash")).findAny().orElseThrow();
  }

  @Test
  void theTableComparesWithOneThread() {
    Metadata origin = new Metadata("", 1, "", "", "", "", Map.of(), Map.of(), "", true);
    List<Row> rows = List.of(row("threads=4", 300), row("threads=1", 100), row("threads=2", 180));

    assertThat(SeriesTables.worlds(new Results(origin, rows)).rows())
        .extracting(row -> row.get(0) + ": " + row.get(4))
        .containsExactly("one thread: 1", "2 threads: 1.8", "4 threads: 3");
  }

  private static Row row(String knob, double value) {
    return new Row(ManyWorlds.SCENE, "carom", knob, ManyWorlds.SPEED, "median", value, "1/s", 1, 0);
  }
}
