// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.World;
import dev.carom.bench.charts.Film;
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
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Runs an example in a window, or draws it. */
@Command(
    name = "example",
    description = {
      "Runs an example in a window; --png draws it, --record films it, both without a screen.",
      "Without a name it lists them."
    },
    footer = {"", "Example: carom-bench example breakout"})
final class ExampleCommand extends BenchCommand {

  /** The height of a line above or under a picture, in pixels. */
  private static final int LINE = 30;

  /** The usual frames of a moving picture: 12 seconds. */
  private static final int FILM = 12 * Example.FRAMES;

  /** A moving picture sees every second frame. */
  private static final int STEP = 2;

  @Parameters(arity = "0..1", paramLabel = "NAME", description = "One of ${COMPLETION-CANDIDATES}.")
  private Examples name;

  @Option(
      names = "--png",
      paramLabel = "FILE",
      description = "Write a picture instead of opening a window.")
  private Path png;

  @Option(
      names = "--record",
      paramLabel = "FILE.svg",
      description = "Write a moving picture, an SVG file, instead of opening a window.")
  private Path film;

  @Option(
      names = "--frames",
      paramLabel = "N",
      description =
          "Frames that are recorded, or that run before the picture"
              + " (default: as suits the example).")
  private Integer frames;

  @Override
  void run() throws IOException {
    if (name == null && (png != null || film != null || frames != null)) {
      throw refused("NAME is missing: expected one of " + Arrays.toString(Examples.values()));
    } else if (name == null) {
      list();
    } else if (png != null) {
      Bounded.atLeast(0, "--frames", frames == null ? 0 : frames, spec);
      draw();
    } else if (film != null) {
      Bounded.atLeast(STEP, "--frames", frames == null ? FILM : frames, spec);
      record(name.after(1)); // which at billiards is the break
    } else {
      Windows.show(
          () -> {
            Style.requireFonts();
            Look.install();
            return ExampleWindow.of("Carom: " + name.about(), name.start());
          });
    }
  }

  private void record(Example example) throws IOException {
    World world =
        Examples.filmed(example)
            .orElseThrow(() -> refused("NAME is " + name + ": expected one of " + filmed()));
    if (!film.toString().endsWith(".svg")) {
      throw refused("--record is " + film + ": expected a name that ends in .svg");
    }
    OutputFile.prepare(film);
    Film seen = new Film(world, (double) STEP / Example.FRAMES);
    for (int frame = 0; frame <= (frames == null ? FILM : frames); frame++) {
      if (frame % STEP == 0) {
        seen.add(world);
      }
      example.frame();
    }
    WholeFile.write(film, seen.svg(name.about()));
  }

  private static List<Examples> filmed() {
    return Arrays.stream(Examples.values())
        .filter(each -> Examples.filmed(each.start()).isPresent())
        .toList();
  }

  private void list() {
    for (Examples each : Examples.values()) {
      println("%-10s %s".formatted(each, each.about()));
    }
  }

  private void draw() throws IOException {
    Style.requireFonts();
    OutputFile.prepare(png);
    Example example = name.after(frames == null ? name.frames() : frames);
    Dimension size = example.size();
    Picture still =
        new Picture(size.width, size.height + 2 * LINE, name.about(), g -> draw(g, example));
    WholeFile.write(png, still.png());
  }

  /** The example, above it what it shows, and under it what its window says there. */
  private void draw(Graphics2D g, Example example) {
    Dimension size = example.size();
    String about = name.about();
    g.setColor(Style.INK);
    g.setFont(Style.bold(LINE / 2.0));
    String title = Character.toUpperCase(about.charAt(0)) + about.substring(1);
    g.drawString(title, LINE / 2, LINE - LINE / 3);
    g.setFont(Style.font(LINE / 2.0));
    g.drawString(example.hint(), LINE / 2, size.height + 2 * LINE - LINE / 3);
    example.draw(g, new Rectangle2D.Double(0, LINE, size.width, size.height));
  }
}
