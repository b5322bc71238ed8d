// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.replay.GoldenRun;
import org.junit.jupiter.api.Test;

class HashCommandTest {

  @Test
  void tellsTheHashOfAScene() {
    Cli run = Cli.run("hash --frames 60 --radius 5");

    assertThat(run.exitCode()).isZero();
    assertThat(run.out()).matches("[0-9a-f]{64}\\R");
    assertThat(Cli.run("hash --frames 60").out()).isNotEqualTo(run.out());
  }

  @Test
  void goldenRunsHaveTheStoredHashes() {
    Cli run = Cli.run("hash");

    assertThat(run.err()).isEmpty();
    assertThat(run.exitCode()).isZero();
    assertThat(run.out().lines())
        .hasSize(GoldenRun.values().length)
        .allSatisfy(
            line ->
                assertThat(line)
                    .matches("\\w+ +[0-9a-f]{64} +[\\d,]+ impacts in +[\\d,]+ frames, as stored"));
  }

  @Test
  void aSceneNeedsFrames() {
    Cli run = Cli.run("hash --radius 5");

    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(run.err()).contains("--frames is missing: expected how many").hasLineCount(1);
  }

  @Test
  void replayDemandsAHash() {
    String hash = Cli.run("hash --frames 60").out().strip();
    String other = hash.replaceFirst("^.", hash.startsWith("0") ? "1" : "0");

    Cli run = Cli.run("replay --frames 60 --demand", other);
    assertThat(run.exitCode()).isEqualTo(1);
    assertThat(run.out()).isEmpty();
    assertThat(run.err())
        .contains("the hash of Carom's run is " + hash + ": expected " + other + ", as demanded")
        .hasLineCount(1);

    Cli usage = Cli.run("replay --demand 12");
    assertThat(usage.exitCode()).isEqualTo(2);
    assertThat(usage.err()).contains("--demand is 12: expected 64 hexadecimal digits");
  }
}
