// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class FuzzCommandTest {

  @Test
  void tellsWhatItPlayed() {
    Cli run = Cli.run("fuzz --sessions 3 --seed 10");

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .matches(
            "no finding in 3 worlds: [\\d,]+ steps, [\\d,]+ impacts, [\\d,]+ flights"
                + " \\([\\d,]+ circles jammed\\)\\R");
    assertThat(Cli.run("fuzz --sessions 3 --seed 10").out()).isEqualTo(run.out());
  }

  @Test
  void aLongRunTellsWhatMustNotHappenAndWhatMustStay() {
    Cli run = Cli.run("fuzz --impacts", 100_000, "--gas", "--circles", 60, "--seed", 2);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out().lines())
        .satisfiesExactly(
            line -> assertThat(line).isEqualTo("soak       --gas --circles 60 --seed 2"),
            line -> assertThat(line).matches("impacts    100,\\d{3}, to time [\\d,]+"),
            line ->
                assertThat(line)
                    .matches("heap       [\\d,]+ KiB in use at the start, [\\d,]+ KiB at the end"),
            line ->
                assertThat(line).startsWith("CPU time   ").contains(" ns per impact at the start"));
    assertThat(run.err().lines()).hasSize(20).last().asString().isEqualTo("round 20 of 20");
  }

  @Test
  void stopsInTime() {
    assertThat(Cli.run("fuzz --seconds 1").out()).startsWith("no finding in ");
  }
}
