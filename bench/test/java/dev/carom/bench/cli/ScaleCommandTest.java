// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ScaleCommandTest {

  @Test
  void tellsTimesGrowthAndMemory(@TempDir Path folder) throws IOException {
    Path csv = folder.resolve("scale.csv");
    Cli run = Cli.run("scale --quick --rounds 1 --warm-up 0 --csv", csv, "--pictures", folder);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out().lines())
        .anyMatch(line -> line.matches("alone +900 +Carom .*"))
        .anyMatch(line -> line.matches("alone +400 +published 2010 .*"))
        .anyMatch(line -> line.matches("gas +900 +Carom .*"))
        .anyMatch(line -> line.matches("gas +400 +dyn4j .*"))
        .noneMatch(line -> line.matches("gas +100 +published 2010 .*"))
        .anyMatch(
            line ->
                line.startsWith(
                    "The time of published 2010 grows with the number of circles that ignore"))
        .anyMatch(line -> line.matches("A world of 102,400 circles and lines takes .* a line\\."));
    assertThat(ResultsCsv.read(csv)).extracting(Row::scene).contains("scale:gas=100");
    assertThat(ResultsCsv.read(csv))
        .filteredOn(row -> row.metric().equals("scale_memory"))
        .hasSize(2)
        .allMatch(row -> row.value() > 8 && row.unit().equals("bytes"));
    assertThat(folder.resolve("scale.png")).isNotEmptyFile();
    assertThat(folder.resolve("scale.svg")).isNotEmptyFile();
  }

  @Test
  void aRoundOfTheReportIsOneOfItsOwn(@TempDir Path folder) throws IOException {
    Path csv = folder.resolve("scale.csv");
    Cli run =
        Cli.run("scale --quick --max 100 --rounds 1 --warm-up 0 --turns 3 --no-memory --csv", csv);
    assertThat(run.exitCode()).isZero();
    assertThat(ResultsCsv.read(csv))
        .isNotEmpty()
        .noneMatch(row -> row.metric().equals("scale_memory"))
        .filteredOn(row -> row.metric().equals("scale_time"))
        .allMatch(row -> row.n() == 1);
  }
}
