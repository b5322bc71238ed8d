// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Scene;
import dev.carom.bench.charts.Style;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.view.Look;
import dev.carom.bench.view.Player;
import dev.carom.bench.view.ViewWindow;
import java.io.IOException;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Opens a window on a scene. */
@Command(
    name = "view",
    description = {
      "Opens a window on the experiment, or on a scene file.",
      "Run, pause, one frame, one impact; scrub through the past; trails, normals, coordinates;"
          + " zoom and pan; drag, throw, add and delete; load and save.",
      "Space runs and pauses, the right arrow goes on by one frame, I by one impact; ? tells all"
          + " keys."
    },
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class ViewCommand implements Callable<Integer> {

  @Spec private CommandSpec spec;

  @Mixin private SceneOptions scenes;

  @Option(
      names = "--dt",
      paramLabel = "D",
      defaultValue = "1",
      description = "The time of a frame at speed 1, 60 a second (default: ${DEFAULT-VALUE}).")
  private double dt;

  @Override
  public Integer call() throws IOException, CannotPlaceException {
    Bounded.positive("--dt", dt, spec);
    Scene scene = scenes.scene();
    Windows.show(
        () -> {
          Style.requireFonts();
          Look.install();
          return ViewWindow.of(scenes.title(), new Player(scene, dt));
        });
    return 0;
  }
}
