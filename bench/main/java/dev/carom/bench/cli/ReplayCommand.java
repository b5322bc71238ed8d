// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Scene;
import dev.carom.bench.charts.Pictures;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.RungCounts;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.replay.ReplayPlan;
import dev.carom.bench.replay.ReplayResult;
import dev.carom.bench.replay.ReplayRun;
import dev.carom.bench.replay.ReplayTable;
import dev.carom.bench.replay.RunHash;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import org.openjdk.jmh.runner.RunnerException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Replays the published experiment with this library and with the published algorithm. */
@Command(
    name = "replay",
    description = {
      "Replays the published experiment, with the published algorithm in the same run.",
      "Tells whether 60 frames per second are met; 'poster' is the published"
          + " algorithm. Runs when no command is given. Takes a minute or two."
    },
    footer = {"", "Example: carom-bench replay --circles 50 --json replay.json"})
final class ReplayCommand extends BenchCommand {

  @Mixin private SceneOptions scene;

  @Option(
      names = "--frames",
      paramLabel = "N",
      defaultValue = "600",
      description = "Frames of one replay (default: ${DEFAULT-VALUE}).")
  private int frames;

  @Option(
      names = "--forks",
      paramLabel = "N",
      defaultValue = "5",
      description =
          "Fresh virtual machines per method, with 20 measured replays each (default:"
              + " ${DEFAULT-VALUE}).")
  private int forks;

  @Option(
      names = "--warm-up",
      paramLabel = "MS",
      defaultValue = "1500",
      description =
          "How long each of them plays before it is measured (default: ${DEFAULT-VALUE}).")
  private int warmUpMillis;

  @Mixin private RowFiles files;

  @Option(
      names = "--pictures",
      paramLabel = "DIR",
      description = "Write pictures of the scene and a chart of the frame times.")
  private Path pictures;

  @Option(
      names = "--demand",
      paramLabel = "HASH",
      description =
          "Fail before anything is measured if Carom's run of the scene has another hash;"
              + " 'hash --frames' prints it.")
  private String demanded;

  @Override
  void run() throws IOException, CannotPlaceException, RunnerException {
    RungCounts.enable();
    ReplayPlan plan = plan();
    checkHash(plan.scene());
    prepareFolders();
    ReplayResult result = measure(plan);
    files.write(Map.of(), false, result.rows());
    print(ReplayTable.render(result));
    if (pictures != null) {
      Pictures.write(
          result.plan().scene(), frames, result.typicalReplay(), Budget.MILLIS, pictures);
    }
  }

  private void checkHash(Scene measured) {
    if (demanded == null) {
      return;
    }
    if (!demanded.matches("\\p{XDigit}{64}")) {
      throw refused("--demand is " + demanded + ": expected 64 hexadecimal digits");
    }
    String found = RunHash.of(measured, frames).hex();
    if (!found.equalsIgnoreCase(demanded)) {
      throw new IllegalStateException(
          "the hash of Carom's run is " + found + ": expected " + demanded + ", as demanded");
    }
    println("The run has the hash that was demanded, " + found + ".%n".formatted());
  }

  /** Before the long work, not after it: a folder that cannot be made. */
  private void prepareFolders() throws IOException {
    files.prepare();
    if (pictures != null) {
      OutputFile.prepareFolder(pictures);
    }
  }

  private ReplayPlan plan() throws IOException, CannotPlaceException {
    Bounded.atLeast(1, "--frames", frames, spec);
    Bounded.atLeast(1, "--forks", forks, spec);
    Bounded.atLeast(0, "--warm-up", warmUpMillis, spec);
    files.expectOther("--scene", scene.file());
    Scene measured = scene.scene();
    return new ReplayPlan(scene.name(), measured, scene.others(), frames, forks, warmUpMillis);
  }

  private static ReplayResult measure(ReplayPlan plan) throws IOException, RunnerException {
    try (Progress progress = Progress.start("replay", plan.steps())) {
      return ReplayRun.run(plan, progress::step);
    }
  }
}
