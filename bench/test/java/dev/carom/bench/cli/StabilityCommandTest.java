// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StabilityCommandTest {

  @TempDir Path folder;

  @Test
  void aMapIsPrintedAndDrawn() throws IOException {
    Cli run =
        Cli.run(
            "stability --quick --map mass --pictures",
            folder.resolve("new"),
            "--csv",
            folder.resolve("new/stability.csv"));

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .startsWith("right at 0.001 and at 0.1 radius  ratio of two masses and restitution")
        .containsPattern("Carom +100 % [|] 100 % +100 % [|] 100 %")
        .doesNotContain("published 2010 ")
        .containsPattern("dyn4j defaults +0 % [|] ");
    assertThat(folder.resolve("new/fails-mass.png")).isNotEmptyFile();
    assertThat(folder.resolve("new/fails-mass.svg")).isNotEmptyFile();
    assertThat(ResultsCsv.read(folder.resolve("new/stability.csv")))
        .filteredOn(row -> row.metric().equals("stability_outcome"))
        .hasSize(15 * 25)
        .extracting(Row::scene)
        .containsOnly("stability:mass");
  }

  @Test
  void aMapThatThereIsNotIsRefused() {
    Cli run = Cli.run("stability --map mass,nosuch");

    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(run.err())
        .contains("--map has nosuch: expected angle, frame, corner, origin, gap, mass")
        .hasLineCount(1);
  }
}
