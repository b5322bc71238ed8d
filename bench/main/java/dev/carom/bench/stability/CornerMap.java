// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Line;
import dev.carom.Scene;

/** A circle that flies into a corner of two lines. */
final class CornerMap {

  private static final double[] DEGREES = {
    5, 8, 12, 16, 20, 30, 40, 50, 60, 75, 90, 105, 120, 140, 160, 175
  };
  private static final double[] RESTITUTIONS = {
    0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99, 1
  };

  private static final double RADIUS = 10;
  private static final double SPEED = 5;
  private static final double APEX_X = 50;
  private static final double APEX_Y = 60;

  /** Angle of the first line to the x axis, in degrees: nothing here is along an axis. */
  private static final double TILT = 13;

  /** Length of the run, in ways into the corner. */
  private static final double LONG = 2.5;

  private CornerMap() {}

  static FailureMap map() {
    return new FailureMap(
        "corner",
        "opening of a corner and restitution",
        "A ball flies into a corner of two lines, at half a radius a frame.",
        Axis.plain("opening of the corner, degrees", DEGREES),
        Axis.plain("restitution", RESTITUTIONS),
        CornerMap::cell);
  }

  /** From the apex the circle stands at 0.42 of the angle, 3 radii from the nearer line. */
  private static Cell cell(double degrees, double restitution) {
    double opening = StrictMath.toRadians(degrees);
    double tilt = StrictMath.toRadians(TILT);
    double way = 3 * RADIUS / StrictMath.sin(Math.min(0.42 * opening, Math.PI / 2));
    double at = tilt + 0.42 * opening;
    double to = at + Math.PI + 0.05 * opening;
    double reach = 4 * way;
    Line first = line(tilt, reach);
    Line second = line(tilt + opening, reach);
    Scene scene =
        Scene.builder()
            .line(first.ax(), first.ay(), first.bx(), first.by())
            .restitution(restitution)
            .line(second.ax(), second.ay(), second.bx(), second.by())
            .restitution(restitution)
            .circle(
                APEX_X + way * StrictMath.cos(at),
                APEX_Y + way * StrictMath.sin(at),
                RADIUS,
                SPEED * StrictMath.cos(to),
                SPEED * StrictMath.sin(to))
            .build();
    WedgeCourse truth = new WedgeCourse(scene, (int) Math.ceil(LONG * way / SPEED));
    Fence fence = (x, y) -> side(first, x, y) < 0 || side(second, x, y) > 0;
    return new Cell(scene, truth, fence, truth.pilesUp());
  }

  private static Line line(double angle, double length) {
    return new Line(
        APEX_X,
        APEX_Y,
        APEX_X + length * StrictMath.cos(angle),
        APEX_Y + length * StrictMath.sin(angle));
  }

  /** Positive to the left of a line. */
  private static double side(Line l, double x, double y) {
    return (l.bx() - l.ax()) * (y - l.ay()) - (l.by() - l.ay()) * (x - l.ax());
  }
}
