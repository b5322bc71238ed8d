// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import dev.carom.bench.results.ResultsJson;
import dev.carom.bench.results.Row;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Starts the finished jar as a person would, its output redirected to a file, on a machine without
 * a screen whose language has digits of its own.
 */
class CaromBenchIT {

  private static final Path JAR = Path.of("target/carom-bench.jar").toAbsolutePath();
  private static final Path JAVA = Path.of(System.getProperty("java.home"), "bin", "java");

  @TempDir private Path folder;

  private Path output;

  private int run(String... args) throws IOException, InterruptedException {
    output = folder.resolve("output.txt");
    // Another JMH run on the same machine disturbs figures, which are not looked at here.
    List<String> command =
        new ArrayList<>(
            List.of(
                JAVA.toString(),
                "-Djmh.ignoreLock=true",
                "-Djava.awt.headless=true",
                "-Duser.language=ar",
                "-Duser.country=EG",
                "-jar",
                JAR.toString()));
    command.addAll(Arrays.asList(args));
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .directory(new File(folder.toString()))
            .start();
    assertThat(process.waitFor(10, TimeUnit.MINUTES)).isTrue();
    assertThat(output).content().doesNotContainPattern("[\u0660-\u0669]");
    return process.exitValue();
  }

  @Test
  void replaysTheExperiment() throws IOException, InterruptedException {
    int exitCode =
        run(
            "replay",
            "--frames",
            "60",
            "--forks",
            "1",
            "--warm-up",
            "100",
            "--json",
            "figures.json");

    assertThat(output).content().contains("BUDGET").contains("published 2010").contains("poster");
    assertThat(exitCode).isZero();
    assertThat(ResultsJson.read(folder.resolve("figures.json")).rows())
        .filteredOn(row -> row.stat().equals("mean") || row.metric().equals("impacts"))
        .extracting(Row::method, Row::metric)
        .contains(tuple("carom", "frame_time"), tuple("poster", "impacts"));
  }

  @Test
  void castsFromAFile() throws IOException, InterruptedException {
    Path queries = folder.resolve("queries.csv");
    Files.writeString(queries, "ax,ay,bx,by,px,py,r,vx,vy,T\n0,0,0,10,-15,4,5,20,0,1\n");

    assertThat(run("cast", queries.toString())).isZero();
    assertThat(output).hasContent("hit,feature,t,nx,ny\n1,SIDE,0.5,-1.0,0.0\n");
  }

  @Test
  void tellsWrongDataByItsExitCode() throws IOException, InterruptedException {
    assertThat(run("cast", "nosuch.csv")).isEqualTo(1);
    assertThat(output).content().contains("nosuch.csv: no such file").doesNotContain("\tat ");
    assertThat(run("--frames")).isEqualTo(2);
    assertThat(run("jmh", "-l")).isZero();
    assertThat(output)
        .content()
        .contains("QueryBenchmark.lineSide")
        .contains("GrowthBenchmark.build");
  }

  @Test
  void aWindowWithoutAScreenTellsOfPictures() throws IOException, InterruptedException {
    for (List<String> words : List.of(List.of("view"), List.of("example", "plinko"))) {
      assertThat(run(words.toArray(String[]::new))).isEqualTo(1);
      assertThat(output)
          .hasContent(
              "carom-bench %s: a window needs a screen, and there is none: --png FILE draws a"
                      .formatted(words.get(0))
                  + " picture instead\n");
    }
  }

  @Test
  void tellsTheRungs() throws IOException, InterruptedException {
    assertThat(run("rungs", "--queries", "10")).isZero();
    assertThat(output).content().contains("\nseg_uniform ").contains("\nall ");
  }
}
