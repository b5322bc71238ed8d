// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.results.ResultsCsv;
import java.io.IOException;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GasCommandTest {

  @Test
  void tellsSpeedAndEnergy(@TempDir Path folder) throws IOException {
    Path csv = folder.resolve("gas.csv");
    Cli run = Cli.run("gas --circles 50 --frames 20 --replays 2 --heavy --csv", csv);

    assertThat(ResultsCsv.read(csv))
        .filteredOn(row -> row.metric().equals("gas_time"))
        .hasSize(1)
        .allMatch(row -> row.value() > 0 && row.n() == 20);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out().lines())
        .satisfiesExactly(
            line ->
                assertThat(line)
                    .isEqualTo("gas      --seed 1 --circles 50 --packing 0.2 --spread 1 --heavy"),
            line -> assertThat(line).isEqualTo("run      20 frames of 1, the fastest of 2 replays"),
            line ->
                assertThat(line).matches("impacts  [\\d,]+ between circles, [\\d,]+ with walls"),
            line ->
                assertThat(line)
                    .matches("speed    [\\d,]+ collisions per second, [\\d,.]+ us per frame"),
            line -> assertThat(line).matches("energy   changed by -?\\d\\.\\de[-+]\\d+ of itself"),
            line ->
                assertThat(line)
                    .matches(
                        "overlap  \\d\\.\\de[-+]\\d+ of a radius at most, at the ends of frames"));
  }

  @Test
  void shorterFramesHaveFewerImpacts() {
    long whole = impacts(Cli.run("gas --frames 20 --replays 1"));
    Cli shorter = Cli.run("gas --frames 20 --replays 1 --frame-time 0.25");

    assertThat(shorter.out()).contains("20 frames of 0.25,");
    assertThat((double) impacts(shorter) / whole).isBetween(0.2, 0.3);
  }

  private static long impacts(Cli run) {
    Matcher found = Pattern.compile("impacts +([\\d,]+) between").matcher(run.out());
    assertThat(found.find()).isTrue();
    return Long.parseLong(found.group(1).replace(",", ""));
  }

  @Test
  void tellsTheSpeedOfTheSteadyState() {
    Cli run = Cli.run("gas --circles 50 --replays 2 --steady 1000");

    assertThat(run.exitCode()).isZero();
    assertThat(run.out().lines())
        .satisfiesExactly(
            line -> assertThat(line).startsWith("gas      --seed 1 --circles 50"),
            line ->
                assertThat(line)
                    .matches(
                        "run      [\\d,]+ frames of the steady state,"
                            + " 2,\\d{3} collisions in 2 rounds"),
            line ->
                assertThat(line)
                    .matches(
                        "speed    [\\d,]+ collisions per second,"
                            + " [\\d,.]+ ns per collision \\([\\d,.]+ \\.\\. [\\d,.]+\\)"),
            line -> assertThat(line).isEqualTo("bytes    0 allocated in the last round"));
  }

  @Test
  void mixesSizes() {
    Cli run = Cli.run("gas --spread 50 --circles 80 --frames 9 --replays 1 --heavy");

    assertThat(run.exitCode()).isZero();
    assertThat(run.out().lines().findFirst())
        .contains("gas      --seed 1 --circles 80 --packing 0.2 --spread 50 --heavy");
  }

  @Test
  void savesTheSceneForOthers(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("gas.csv");
    Cli.run("gas --circles 9 --frames 1 --replays 1 --save", file);

    assertThat(Scene.read(file).collide()).isTrue();
    assertThat(Scene.read(file).count(Kind.CIRCLE)).isEqualTo(9);
    assertThat(Cli.run("simulate --scene", file, "--frames", 1).exitCode()).isZero();
  }
}
