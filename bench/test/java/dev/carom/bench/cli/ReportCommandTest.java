// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.ResultsJson;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReportCommandTest {

  @TempDir Path folder;

  @Test
  void aReportIsMadeAnewFromStoredResults() throws IOException {
    Row row = new Row("base-1", "carom", "", "frame_time", "worst", 2000, "ns", 600, 0);
    Metadata metadata = new Metadata("", 1, "", "", "", "", Map.of(), Map.of(), "", true);
    ResultsJson.write(new Results(metadata, List.of(row)), folder.resolve("results.json"));

    Cli run = Cli.run("report --from", folder, "--out", folder.resolve("new"));

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .contains("Budget: met; the slowest frame of Carom in 1 scene takes 2 µs")
        .endsWith("report: " + folder.resolve("new/report.html") + System.lineSeparator());
    assertThat(folder.resolve("new/report.html")).isNotEmptyFile();
    assertThat(ResultsCsv.read(folder.resolve("new/results.csv"))).containsExactly(row);
  }

  @Test
  void damagedResultsAreOneLine() throws IOException {
    Files.writeString(folder.resolve("results.json"), "{\"version\":1,\n\"metadata\":x}");
    Cli run = Cli.run("report --from", folder);
    assertThat(run.exitCode()).isEqualTo(1);
    assertThat(run.err()).contains("results.json:2:").hasLineCount(1);
    Cli missing = Cli.run("report --from", folder.resolve("nosuch"));
    assertThat(missing.exitCode()).isEqualTo(1);
    assertThat(missing.err()).contains("nosuch").hasLineCount(1);
  }

  @Test
  void nothingIsMeasuredFromStoredResults() {
    assertThat(Cli.run("report --from", folder, "--quick").err())
        .contains("--from and --quick exclude each other")
        .hasLineCount(1);
    assertThat(Cli.run("report --from", folder, "--date", "today").exitCode()).isEqualTo(2);
  }

  @Test
  void figuresAreWrittenBetweenTheMarksOfPages() throws IOException {
    Metadata metadata = new Metadata("", 1, "", "", "", "", Map.of(), Map.of(), "2026-01-02", true);
    ResultsJson.write(new Results(metadata, List.of()), folder.resolve("results.json"));
    Path page = folder.resolve("page.md");
    Files.writeString(page, "run on <!--date-->?<!--/date-->.");

    Cli run = Cli.run("report --from", folder, "--readme", page);

    assertThat(run.exitCode()).isZero();
    assertThat(page).hasContent("run on <!--date-->2026-01-02<!--/date-->.");
    assertThat(folder.resolve("report.html")).doesNotExist();
    assertThat(Cli.run("report --readme", page).err())
        .contains("--readme needs --from, and excludes --out")
        .hasLineCount(1);
  }

  @Test
  void scenesThatThereAreNotAreRefused() {
    assertThat(Cli.run("report --quick --scenes base-1,nosuch --out", folder).err())
        .contains("--scenes has nosuch: expected base-1")
        .hasLineCount(1);
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void theSweepPrintsItsTableAndWritesItsFiles() throws IOException {
    Path csv = folder.resolve("sweep.csv");
    Cli run = Cli.run("sweep --quick --frames 6 --replays 1 --csv", csv, "--pictures", folder);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .containsPattern("circles +100 +Carom")
        .contains("The time of published 2010 grows with the number of lines to the power");
    assertThat(ResultsCsv.read(csv)).extracting(Row::scene).contains("sweep:radius=20");
    assertThat(folder.resolve("sweep.png")).isNotEmptyFile();
    assertThat(folder.resolve("sweep.svg")).isNotEmptyFile();
  }

  @Test
  void aSweepOfNoReplaysIsRefused() {
    assertThat(Cli.run("sweep --replays 0").err()).contains("--rounds is 0: expected at least 1");
  }
}
