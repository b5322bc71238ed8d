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
  void tellsWhatItAsked() {
    Cli run = Cli.run("fuzz --queries", 1_000);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .matches("no finding in 1,000 queries: \\d+ hits, \\d+ refused as they must be\\R");
  }

  @Test
  void aLongRunTellsWhatMustNotHappenAndWhatMustStay() {
    Cli run = Cli.run("fuzz --impacts", 100_000, "--gas", "--circles", 60, "--seed", 2);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out().lines())
        .satisfiesExactly(
            line -> assertThat(line).isEqualTo("soak       --gas --circles 60 --seed 2"),
            line -> assertThat(line).matches("impacts    100,\\d{3}, to time [\\d,]+"),
            line -> assertThat(line).isEqualTo("escapes    0 circles outside of the bounds"),
            line ->
                assertThat(line)
                    .isEqualTo("crossings  0 flights through a line, 0 pairs inside of each other"),
            line ->
                assertThat(line)
                    .matches(
                        "energy     changed by -?\\d\\.\\de-\\d+ of itself, at most 1e-11 expected"),
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

  @Test
  void refusesWhatIsNoFuzz() {
    assertThat(Cli.run("fuzz --seconds 0").err()).contains("--seconds is 0: expected at least");
    assertThat(Cli.run("fuzz --queries 0").err()).contains("--queries is 0: expected at least");
    assertThat(Cli.run("fuzz --sessions 0").exitCode()).isEqualTo(2);
    assertThat(Cli.run("fuzz --impacts", 100_000, "--scene", "heap", "--gas").err())
        .contains("--scene and --gas exclude each other");
  }
}
