// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import java.util.Arrays;

/** One circle in a box of four lines, whose course unfolds. */
final class BoxMaps {

  static final double RADIUS = 10;

  /** Share of the frames before the first impact. */
  static final double BEFORE = 0.37;

  private static final double WIDTH = 400;
  private static final double HEIGHT = 300;
  private static final int FRAMES = 100;
  private static final int MOST_FRAMES = 1000;

  private BoxMaps() {}

  static FailureMap angles() {
    return new FailureMap(
        "angle",
        "speed and angle of impact",
        "One ball bounces for 100 frames in a box of four lines, 40 x 30 radii.",
        Axis.decades("speed, in radii a frame", -3, 3, 2),
        degrees(),
        (speed, angle) -> cell(speed * RADIUS, angle, FRAMES));
  }

  static FailureMap frames() {
    return new FailureMap(
        "frame",
        "length of a frame and angle of impact",
        "One ball bounces in a box of four lines, 40 x 30 radii, in shorter or longer frames.",
        Axis.decades("length of a frame, in crossings of the box", -6, 6, 1),
        degrees(),
        (crossings, angle) ->
            cell(crossings * (WIDTH - 2 * RADIUS), angle, framesOf(3 / crossings)));
  }

  private static int framesOf(double wanted) {
    return (int) Math.max(1, Math.min(MOST_FRAMES, Math.rint(wanted)));
  }

  private static Axis degrees() {
    double[] values = new double[12];
    Arrays.setAll(values, i -> 8 * i);
    return Axis.plain("angle of impact, degrees off head-on", values);
  }

  /** The circle starts where the wall is so far away, but not beyond the middle of the box. */
  private static Cell cell(double speed, double degrees, int frames) {
    double angle = StrictMath.toRadians(degrees);
    double vx = speed * StrictMath.cos(angle);
    double vy = speed * StrictMath.sin(angle);
    double gap = Math.min(WIDTH / 2 + 7.3, BEFORE * frames * vx);
    SceneBuilder setup = Scene.builder().line(0, 0, WIDTH, 0).line(WIDTH, 0, WIDTH, HEIGHT);
    setup.line(WIDTH, HEIGHT, 0, HEIGHT).line(0, HEIGHT, 0, 0);
    setup.circle(WIDTH - RADIUS - gap, 120.7, RADIUS, vx, vy);
    Scene scene = setup.build();
    BoxCourse truth = new BoxCourse(scene, WIDTH, HEIGHT, frames);
    Fence fence = (x, y) -> x < 0 || x > WIDTH || y < 0 || y > HEIGHT;
    return new Cell(scene, truth, fence, false);
  }
}
