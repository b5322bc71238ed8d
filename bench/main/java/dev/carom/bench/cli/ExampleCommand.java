// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.charts.Picture;
import dev.carom.bench.charts.Style;
import dev.carom.bench.examples.Example;
import dev.carom.bench.examples.ExampleWindow;
import dev.carom.bench.examples.Examples;
import dev.carom.bench.results.WholeFile;
import dev.carom.bench.view.Look;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Runs an example in a window, or draws it. */
@Command(
    name = "example",
    description = {
      "Runs an example in a window, or draws it with --png, without a screen.",
      "Without a name it lists them."
    },
    footer = {"", "Example: carom-bench example breakout"},
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class ExampleCommand implements Callable<Integer> {

  /** The height of the line under a picture, in pixels. */
  private static final int HINT = 30;

  @Spec private CommandSpec spec;

  @Parameters(arity = "0..1", paramLabel = "NAME", description = "One of ${COMPLETION-CANDIDATES}.")
  private Examples name;

  @Option(
      names = "--png",
      paramLabel = "FILE",
      description = "Write a picture instead of opening a window.")
  private Path png;

  @Option(
      names = "--frames",
      paramLabel = "N",
      description = "Frames that run before the picture (default: as suits the example).")
  private Integer frames;

  @Override
  public Integer call() throws IOException {
    if (name == null && (png != null || frames != null)) {
      throw new ParameterException(
          spec.commandLine(),
          "NAME is missing: expected one of " + Arrays.toString(Examples.values()));
    } else if (name == null) {
      list();
    } else if (png != null) {
      Bounded.atLeast(0, "--frames", frames == null ? 0 : frames, spec);
      draw();
    } else {
      Windows.show(
          () -> {
            Style.requireFonts();
            Look.install();
            return ExampleWindow.of("Carom: " + name.about(), name.start());
          });
    }
    return 0;
  }

  private void list() {
    for (Examples each : Examples.values()) {
      spec.commandLine().getOut().printf("%-10s %s%n", each, each.about());
    }
    spec.commandLine().getOut().flush();
  }

  private void draw() throws IOException {
    Style.requireFonts();
    OutputFile.prepare(png);
    Example example = name.after(frames == null ? name.frames() : frames);
    Dimension size = example.size();
    Picture still =
        new Picture(size.width, size.height + HINT, name.about(), g -> draw(g, example));
    WholeFile.write(png, still.png());
  }

  /** The example, and under it what its window says there. */
  private static void draw(Graphics2D g, Example example) {
    Dimension size = example.size();
    g.setColor(Style.INK);
    g.setFont(Style.font(HINT / 2.0));
    g.drawString(example.hint(), HINT / 2, size.height + HINT - HINT / 3);
    example.draw(g, new Rectangle2D.Double(0, 0, size.width, size.height));
  }
}
