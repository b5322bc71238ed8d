// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.measures.RungSurvey;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RungsCommandTest {

  @Test
  void tableHasARowForEachFamilyAndOneForAll() {
    Cli run = Cli.run("rungs", "--queries", 20);

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

    assertThat(Cli.run("rungs", "--queries", 50, "--csv", file).exitCode()).isZero();

    List<String> rows = Files.readAllLines(file);
    assertThat(rows.get(0))
        .isEqualTo(
            "family,queries,plain,double_double,exact,times,times_double_double,times_exact");
    assertThat(rows).hasSize(1 + RungSurvey.families());
    for (String row : rows.subList(1, rows.size())) {
      String[] fields = row.split(",", -1);
      assertThat(sum(fields, 2, 3, 4)).as(row).isEqualTo(50);
      assertThat(sum(fields, 6, 7)).as(row).isEqualTo(sum(fields, 5));
    }
  }

  private static long sum(String[] fields, int... columns) {
    long sum = 0;
    for (int column : columns) {
      sum += Long.parseLong(fields[column]);
    }
    return sum;
  }
}
