// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class FuzzCommandTest {

  @Test
  void tellsWhatItPlayed() {
    Cli run = Cli.run("fuzz", "--sessions", 3, "--seed", 10);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .matches(
            "no finding in 3 worlds: [\\d,]+ steps, [\\d,]+ impacts, [\\d,]+ flights"
                + " \\([\\d,]+ circles jammed\\)\\R");
    assertThat(Cli.run("fuzz", "--sessions", 3, "--seed", 10).out()).isEqualTo(run.out());
  }

  @Test
  void tellsWhatItAsked() {
    Cli run = Cli.run("fuzz", "--queries", 1_000);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .matches("no finding in 1,000 queries: \\d+ hits, \\d+ refused as they must be\\R");
  }

  @Test
  void stopsInTime() {
    assertThat(Cli.run("fuzz", "--seconds", 1).out()).startsWith("no finding in ");
  }

  @Test
  void refusesWhatIsNoFuzz() {
    assertThat(Cli.run("fuzz", "--seconds", 0).err()).contains("--seconds is 0: expected at least");
    assertThat(Cli.run("fuzz", "--queries", 0).err()).contains("--queries is 0: expected at least");
    assertThat(Cli.run("fuzz", "--sessions", 0).exitCode()).isEqualTo(2);
  }
}
