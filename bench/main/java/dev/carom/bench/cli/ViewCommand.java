// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.charts.Courses;
import dev.carom.bench.charts.Motion;
import dev.carom.bench.charts.Picture;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import dev.carom.bench.duel.Duel;
import dev.carom.bench.duel.PlayedFrame;
import dev.carom.bench.duel.Preset;
import dev.carom.bench.duel.Rival;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.PlainScene;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.reference.References;
import dev.carom.bench.results.WholeFile;
import dev.carom.bench.view.Look;
import dev.carom.bench.view.Player;
import dev.carom.bench.view.ViewWindow;
import java.awt.Dimension;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Opens a window on a scene, alone or beside another method. */
@Command(
    name = "view",
    description = {
      "Opens a window on the experiment, or on a scene file.",
      "Run, pause, one frame, one impact; scrub through the past; trails, normals, coordinates;"
          + " zoom and pan; drag, throw, add and delete; load and save.",
      "Space runs and pauses, the right arrow goes on by one frame, I by one impact; ? tells all"
          + " keys.",
      "With --against another method plays the same scene beside Carom."
    },
    footer = {"", "Example: carom-bench view --scene scene.csv"})
final class ViewCommand extends BenchCommand {

  private static final double FRAMES_A_SECOND = 60;

  @Mixin private SceneOptions scenes;

  @Option(
      names = "--dt",
      paramLabel = "D",
      defaultValue = "1",
      description = "The time of a frame at speed 1, 60 a second (default: ${DEFAULT-VALUE}).")
  private double dt;

  @Option(
      names = "--preset",
      paramLabel = "NAME",
      description =
          "Show a scene in which methods fail within five seconds: fast, gap, corner, shallow,"
              + " slow, wedge or row.")
  private Preset preset;

  @Option(
      names = "--against",
      paramLabel = "METHOD",
      description =
          "Let another method play the same scene, in which obstacles rest: box2d, dyn4j, jbox2d;"
              + " or, at their best, box2d-best, dyn4j-best, jbox2d-best; without gravity also"
              + " published, substeps.")
  private Rival rival;

  @Option(
      names = "--record",
      paramLabel = "FILE",
      description =
          "Write the motion, or with --against that of both sides, instead of opening a window: an"
              + " animated picture if the name ends in .svg, a page with a slider if in .html.")
  private Path record;

  @Option(
      names = "--slow",
      paramLabel = "N",
      defaultValue = "1",
      description = "Record the motion N times as slow (default: ${DEFAULT-VALUE}).")
  private double slow;

  @Option(
      names = "--png",
      paramLabel = "FILE",
      description = "Write a picture of the scene instead of opening a window.")
  private Path png;

  @Option(
      names = "--frames",
      paramLabel = "N",
      defaultValue = "300",
      description =
          "Frames that are recorded, or that run before the picture (default: ${DEFAULT-VALUE}).")
  private int frames;

  @Override
  void run() throws IOException, CannotPlaceException {
    Bounded.positive("--dt", dt, spec);
    Bounded.atLeast(record == null ? 0 : 1, "--frames", frames, spec);
    Bounded.positive("--slow", slow, spec);
    check();
    Scene scene = preset == null ? scenes.scene() : preset.scene();
    if (rival != null && !PlainScene.isAtRest(scene)) {
      throw refused("--against plays scenes whose obstacles rest: a line or a peg moves");
    }
    String title = preset == null ? scenes.title() : preset.about();
    Reference truth = rival == null ? null : truth(scene);
    if (png != null) {
      draw(scene, title);
    } else if (record == null) {
      Windows.show(
          () -> {
            Style.requireFonts();
            Look.install();
            return ViewWindow.of(title, new Player(scene, dt), truth, rival);
          });
    } else {
      record(scene, title);
    }
  }

  private void record(Scene scene, String title) throws IOException {
    OutputFile.prepare(record);
    List<Motion.Side> sides = new ArrayList<>();
    sides.add(new Motion.Side("Carom", Courses.of(scene, frames, dt)));
    if (rival != null) {
      try (Duel duel = new Duel(scene, rival, null)) {
        lose(sides.get(0).courses(), duel::carom);
        Courses courses =
            Courses.of(scene, frames, (k, i) -> duel.rival(k).x(i), (k, i) -> duel.rival(k).y(i));
        lose(courses, duel::rival);
        sides.add(new Motion.Side(rival.title(), courses));
      }
    }
    double seconds = slow * frames / FRAMES_A_SECOND;
    String svg = Motion.svg(scene, title, sides, seconds);
    WholeFile.write(record, isPage() ? Motion.html(svg, title, seconds) : svg);
  }

  private boolean isPage() {
    return record.toString().endsWith(".html");
  }

  private void lose(Courses courses, IntFunction<PlayedFrame> played) {
    PlayedFrame end = played.apply(frames);
    for (int i = 0; i < end.circles(); i++) {
      int frame = 0;
      while (frame <= frames && !played.apply(frame).isLost(i)) {
        frame++;
      }
      if (frame <= frames) {
        courses.lost(i, frame);
      }
    }
  }

  private void draw(Scene scene, String title) throws IOException {
    Style.requireFonts();
    OutputFile.prepare(png);
    World world = new World(scene);
    for (int frame = 0; frame < frames; frame++) {
      world.step(dt);
    }
    SceneDrawing drawing = SceneDrawing.of(WorldScene.of(world));
    Dimension size = drawing.size(Picture.WIDE, Picture.WIDE);
    Rectangle2D area = new Rectangle2D.Double(0, 0, size.width, size.height);
    Still still = Still.of(world);
    WholeFile.write(
        png, new Picture(size.width, size.height, title, g -> drawing.draw(g, area, still)).png());
  }

  /** Null where it is not known. */
  private Reference truth(Scene scene) throws IOException {
    if (preset != null) {
      return preset.truth();
    }
    for (String name : References.SCENES) {
      if (References.scene(name).equals(scene)) {
        return References.load(name);
      }
    }
    return null;
  }

  private void check() {
    if (preset != null && scenes.isGiven()) {
      throw refused("--preset excludes the options of other scenes");
    }
    if (record != null && !isPage() && !record.toString().endsWith(".svg")) {
      throw refused("--record is " + record + ": expected a name that ends in .svg or .html");
    }
    if (png != null && (rival != null || record != null)) {
      throw refused("--png draws one side: --against and --record exclude it");
    }
    if (rival != null && dt != 1) {
      throw refused("--against plays frames of 1 unit of time: --dt is " + dt);
    }
  }
}
