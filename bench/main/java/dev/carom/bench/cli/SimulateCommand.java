// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Scene;
import dev.carom.Warning;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Plays a scene from a file and writes what happens. */
@Command(
    name = "simulate",
    description = {
      "Plays a scene and writes positions and impacts.",
      "Times count in the scene's own unit from 0; frame k ends at k times the length of a frame."
    },
    footer = {"", "Example: carom-bench simulate --scene scene.csv --frames 600 --impacts out.csv"})
final class SimulateCommand extends BenchCommand {

  private static final int MOST_WARNINGS = 10;

  @Option(names = "--scene", paramLabel = "FILE", required = true, description = "The scene.")
  private Path file;

  @Option(
      names = "--frames",
      paramLabel = "N",
      required = true,
      description = "How many frames to play.")
  private int frames;

  @Option(
      names = "--dt",
      paramLabel = "D",
      defaultValue = "1",
      description = "The length of a frame (default: ${DEFAULT-VALUE}).")
  private double dt;

  @Option(
      names = "--positions",
      paramLabel = "OUT.csv",
      description = "Write frame,circle,x,y after every frame.")
  private Path positions;

  @Option(
      names = "--impacts",
      paramLabel = "OUT.csv",
      description =
          "Write time,circle,obstacle,feature,x,y,nx,ny,speed,outcome of every impact: x,y is the"
              + " contact point, nx,ny the unit normal to the circle, speed the approach speed,"
              + " outcome what the impact did: BOUNCED, HALTED, SENSED, PASSED, JAMMED, STOPPED or"
              + " SETTLED.")
  private Path impacts;

  @Override
  void run() throws IOException {
    Bounded.atLeast(0, "--frames", frames, spec);
    Bounded.positive("--dt", dt, spec);
    if (!(frames * dt <= Double.MAX_VALUE)) {
      throw refused("--dt is " + dt + ": expected a finite time after " + frames + " frames");
    }
    OutputFile.expectOther("--impacts", impacts, "--positions", positions, spec);
    OutputFile.expectOther("--positions", positions, "--scene", file, spec);
    OutputFile.expectOther("--impacts", impacts, "--scene", file, spec);
    Scene scene = Scene.read(file);
    warn(scene.warnings());
    try (OutputFile positionsFile = OutputFile.open(positions, Recorder.POSITIONS);
        OutputFile impactsFile = OutputFile.open(impacts, Recorder.IMPACTS)) {
      Recorder recorder = new Recorder(positionsFile, impactsFile);
      Simulation simulation = new Simulation(scene, recorder);
      simulation.play(frames, dt);
      recorder.commit();
      println(simulation.summary());
    }
  }

  /** Tells of circles that begin where they overlap something, of so many and no more. */
  private void warn(List<Warning> warnings) {
    String prefix = spec.qualifiedName() + ": warning: ";
    PrintWriter err = spec.commandLine().getErr();
    warnings.stream().limit(MOST_WARNINGS).forEach(warning -> err.println(prefix + warning));
    if (warnings.size() > MOST_WARNINGS) {
      err.println(prefix + "and " + (warnings.size() - MOST_WARNINGS) + " more");
    }
    err.flush();
  }
}
