// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.results.WholeFile;
import java.awt.Dimension;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes the pictures of one run: {@code initial}, {@code middle}, {@code final} and {@code
 * frame-times}, each as {@code .png} and {@code .svg}, and {@code motion.gif}. No screen is needed,
 * only a font.
 */
public final class Pictures {

  /** Frames of the motion. */
  static final int MOTION_FRAMES = 120;

  private static final int MOTION_WIDTH = 400;
  private static final int MOTION_HEIGHT = 300;
  private static final double MOTION_MARGIN = 6;
  private static final int MOTION_COLORS = 32;

  /** Duration of a frame in hundredths of a second. Browsers slow down frames below 2. */
  private static final int MOTION_DELAY = 4;

  private static final int MOTION_REST = 100;

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
    FrameTimeChart chart = new FrameTimeChart(frameNanos, budgetMillis);
    Style.requireFonts();
    Pictures pictures = new Pictures(dir);
    pictures.createDirectory();
    pictures.scene(scene, frames);
    pictures.put("frame-times", chart.picture());
  }

  private void scene(Scene scene, int frames) throws IOException {
    Replay replay = Replay.of(scene, frames, MOTION_FRAMES);
    SceneDrawing drawing = SceneDrawing.of(scene);
    String what = contents(scene);
    String of = " of " + frames;
    put("initial", ScenePicture.of(drawing, Still.of(scene), "Frame 0" + of, what));
    put("middle", ScenePicture.of(drawing, replay.middle(), "Frame " + frames / 2 + of, what));
    put("final", ScenePicture.of(drawing, replay.end(), "Frame " + frames + of, what));
    put("motion.gif", motion(drawing.withArrowTime(0).withMargin(MOTION_MARGIN), replay.opening()));
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

  private static byte[] motion(SceneDrawing drawing, List<Still> stills) throws IOException {
    Dimension size = drawing.size(MOTION_WIDTH, MOTION_HEIGHT);
    Rectangle2D area = new Rectangle2D.Double(0, 0, size.width, size.height);
    List<BufferedImage> images =
        stills.stream()
            .map(
                still ->
                    new Picture(size.width, size.height, "", g -> drawing.draw(g, area, still))
                        .image(1))
            .toList();
    return AnimatedGif.of(images, MOTION_COLORS, MOTION_DELAY, MOTION_REST);
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
