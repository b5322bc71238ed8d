// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.charts.FrameStripsChart.Strip;
import dev.carom.bench.results.WholeFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes the pictures of one run: {@code initial}, {@code middle}, {@code final} and {@code
 * frame-times}, each as {@code .png} and {@code .svg}, and {@code motion.svg}. No screen is needed,
 * only a font.
 */
public final class Pictures {

  private static final double FRAMES_A_SECOND = 60;

  private final Path dir;

  private Pictures(Path dir) {
    this.dir = dir;
  }

  /**
   * Runs a scene once more and draws it; draws the frame times that were measured before.
   *
   * @param frames the number of frames to run, each of length 1, at least 0
   * @param frameNanos the time of each frame of a replay in nanoseconds, finite and at least 0; at
   *     least one
   * @param budgetMillis what a frame may take, in milliseconds, finite and greater than 0
   * @param dir where to write; it is created if need be, and files of these names are replaced
   * @throws IllegalArgumentException if a number is refused
   * @throws IllegalStateException if there is no font, or a frame spent the world's budget of work
   * @throws IOException if a file cannot be written; the message names it
   */
  public static void write(
      Scene scene, int frames, double[] frameNanos, double budgetMillis, Path dir)
      throws IOException {
    if (frames < 0) {
      throw new IllegalArgumentException("frames is " + frames + ": expected at least 0");
    }
    check(frameNanos, budgetMillis);
    Style.requireFonts();
    Pictures pictures = new Pictures(dir);
    pictures.createDirectory();
    pictures.scene(scene, frames);
    pictures.put("frame-times", frameTimes(frameNanos, 1e6 * budgetMillis));
  }

  private static void check(double[] frameNanos, double budgetMillis) {
    if (frameNanos.length == 0) {
      throw new IllegalArgumentException("frameNanos is empty: expected at least one frame");
    }
    for (int i = 0; i < frameNanos.length; i++) {
      if (!(frameNanos[i] >= 0 && frameNanos[i] < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException(
            "frameNanos[" + i + "] is " + frameNanos[i] + ": expected a finite time, at least 0");
      }
    }
    if (!(budgetMillis > 0 && budgetMillis < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "budgetMillis is " + budgetMillis + ": expected a finite time greater than 0");
    }
  }

  private static Picture frameTimes(double[] nanos, double budget) {
    Strip strip = new Strip("carom", "", nanos);
    String title =
        "Carom's slowest of %s frames takes %s of the %s allowed"
            .formatted(
                Durations.number(nanos.length, 9),
                Durations.text(strip.rank(1), 3),
                Durations.text(budget, 4));
    Marks marks = new Marks(List.of("carom"), method -> "Carom");
    return Sheet.of(
        title,
        "Each dot is one frame of a replay. Thick line: median. Dashed: what is allowed.",
        List.of(
            new Panel("", new FrameStripsChart(title, marks, List.of(strip), budget).picture())));
  }

  private void scene(Scene scene, int frames) throws IOException {
    SceneDrawing drawing = SceneDrawing.of(scene);
    String what = contents(scene);
    String of = " of " + frames;
    put("initial", ScenePicture.of(drawing, Still.of(scene), "Frame 0" + of, what));
    put(
        "middle",
        ScenePicture.of(drawing, after(scene, frames / 2), "Frame " + frames / 2 + of, what));
    put("final", ScenePicture.of(drawing, after(scene, frames), "Frame " + frames + of, what));
    List<Motion.Side> alone = List.of(new Motion.Side("Carom", Courses.of(scene, frames, 1)));
    double seconds = Math.max(1, frames) / FRAMES_A_SECOND;
    put("motion.svg", Motion.svg(scene, what, alone, seconds).getBytes(StandardCharsets.UTF_8));
  }

  private static Still after(Scene scene, int frames) {
    World world = new World(scene);
    for (int frame = 0; frame < frames; frame++) {
      world.step(1);
    }
    return Still.of(world);
  }

  private static String contents(Scene scene) {
    String pegs = scene.count(Kind.PEG) == 0 ? "" : ", " + count(scene.count(Kind.PEG), "peg");
    return count(scene.count(Kind.CIRCLE), "circle")
        + ", "
        + count(scene.count(Kind.LINE), "line")
        + pegs;
  }

  private static String count(int n, String thing) {
    return n + " " + thing + (n == 1 ? "" : "s");
  }

  private void createDirectory() throws IOException {
    try {
      Files.createDirectories(dir);
    } catch (IOException e) {
      throw new IOException("cannot create the folder " + dir + ": " + e, e);
    }
  }

  private void put(String name, Picture picture) throws IOException {
    put(name + ".png", picture.png());
    put(name + ".svg", picture.svg());
  }

  private void put(String name, byte[] bytes) throws IOException {
    WholeFile.write(dir.resolve(name), bytes);
  }
}
