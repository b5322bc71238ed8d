// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.measures.RungSurvey;
import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RungsCommandTest {

  @Test
  void tableHasARowForEachFamilyAndOneForAll() {
    Cli run = Cli.run("rungs --queries 20");

    assertThat(run.exitCode()).isZero();
    List<String> rows = run.out().lines().toList();
    assertThat(rows).hasSize(2 + RungSurvey.families() + 1);
    assertThat(rows.subList(1, rows.size()))
        .allSatisfy(row -> assertThat(row).matches("\\w+( +(\\S+ %|-|\\S+)){6}"))
        .allSatisfy(row -> assertThat(row).hasSize(rows.get(1).length()));
    assertThat(rows.get(rows.size() - 1)).startsWith("all ");
  }

  @Test
  void fileHasTheCountsThatAddUp(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("rungs.csv");

    assertThat(Cli.run("rungs --queries 50 --csv", file).exitCode()).isZero();

    List<Row> rows = ResultsCsv.read(file);
    assertThat(rows).hasSize(7 * RungSurvey.families());
    for (int i = 0; i < rows.size(); i += 7) {
      double[] counts = rows.subList(i, i + 7).stream().mapToDouble(Row::value).toArray();
      assertThat(counts[0]).as("%s", rows.get(i)).isEqualTo(50);
      assertThat(counts[1] + counts[2] + counts[3]).as("%s", rows.get(i)).isEqualTo(50);
      assertThat(counts[5] + counts[6]).as("%s", rows.get(i)).isEqualTo(counts[4]);
    }
  }

  @Test
  void scenesFollowWithTheirFalls(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("rungs.csv");

    Cli run = Cli.run("rungs", "--queries", 1, "--scenes", "--csv", file);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .containsPattern("feature:gravity +[1-9]\\d* +\\d+ +\\d+ +\\d+ +[1-9]\\d*");
    assertThat(ResultsCsv.read(file))
        .anySatisfy(
            row -> {
              assertThat(row.scene()).isEqualTo("feature:gravity");
              assertThat(row.metric()).isEqualTo("rungs_of_falls");
              assertThat(row.value()).isPositive();
            });
  }
}
