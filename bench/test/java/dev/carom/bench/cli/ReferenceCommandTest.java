// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReferenceCommandTest {

  @Test
  void tellsWhatItTook() {
    Cli run = Cli.run("reference", "base-1", "radii", "--frames", 5);

    assertThat(run.exitCode()).isZero();
    List<String> rows = run.out().lines().toList();
    assertThat(rows).hasSize(3);
    assertThat(rows.get(1)).startsWith("base-1").hasSize(rows.get(0).length());
    assertThat(rows.get(2)).startsWith("radii ").hasSize(rows.get(0).length());
  }

  @Test
  void writesFiles(@TempDir Path folder) {
    Path target = folder.resolve("references");

    Cli run = Cli.run("reference", "base-1", "--frames", 5, "--write", target);

    assertThat(run.exitCode()).isZero();
    assertThat(target.resolve("base-1.flights")).isNotEmptyFile();
  }

  @Test
  void goesBack() {
    Cli run = Cli.run("reference", "base-1", "--frames", 5, "--back");

    assertThat(run.exitCode()).isZero();
    assertThat(run.out()).containsPattern("base-1 .* 100 of 100");
  }

  @Test
  void namesTheScenesItKnows() {
    Cli run = Cli.run("reference", "base-9");

    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(run.err()).contains("SCENE is base-9: expected one of [base-1");
  }

  @Test
  void storesNothingOnTheWayBack(@TempDir Path folder) {
    Cli run = Cli.run("reference", "base-1", "--back", "--write", folder);

    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(run.err()).contains("--back and --write exclude each other");
    assertThat(folder).isEmptyDirectory();
  }
}
