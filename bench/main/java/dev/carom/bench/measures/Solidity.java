// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Bounds;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Whether lines and walls hold: how deep circles reach into them at the end of a frame, how many
 * circles ever get through a line, and how many ever leave the bounds, or are outside at the end.
 *
 * <p>A circle got through a line if it provably did: its centre is on the other side at the end of
 * a frame, with the line between the two places, and the way round either end is longer than a
 * frame's travel at its greater speed. A legal trip round an end is never counted.
 */
final class Solidity {

  /** What rounding may add to a frame's travel. */
  private static final double MARGIN = 1 + 1e-6;

  private final Scene scene;
  private final RecordedRun run;

  Solidity(Scene scene, RecordedRun run) {
    this.scene = scene;
    this.run = run;
  }

  List<Row> rows(Trial trial) {
    List<Row> rows = new ArrayList<>();
    long n = (long) run.frames() * run.circles();
    rows.add(trial.row("penetration", "max", deepest(), Trial.RADII, n));
    rows.add(trial.row("tunnelled", "circles", tunnelled(), Trial.ONE, run.circles()));
    rows.add(trial.row("escaped", "circles", escaped(0), Trial.ONE, run.circles()));
    int end = run.frames();
    rows.add(trial.row("outside_at_end", "circles", escaped(end), Trial.ONE, run.circles()));
    rows.addAll(Drift.rows(trial, "drift_penetration", Trial.RADII, run.frames(), this::depths));
    return rows;
  }

  private double deepest() {
    double deepest = 0;
    for (int frame = 1; frame <= run.frames(); frame++) {
      deepest = Math.max(deepest, new Quantiles(depths(frame)).max());
    }
    return deepest;
  }

  private double[] depths(int frame) {
    double[] depths = new double[run.circles()];
    Arrays.setAll(depths, i -> depth(run.x(frame, i), run.y(frame, i), i));
    return depths;
  }

  /**
   * In radii, 0 if it touches nothing; a circle outside of the bounds is no longer held by them.
   */
  private double depth(double x, double y, int i) {
    if (Double.isNaN(x + y)) {
      return Double.NaN;
    }
    double room = isInside(x, y) ? roomToWalls(x, y) : Double.POSITIVE_INFINITY;
    Vec2 centre = new Vec2(x, y);
    for (int k = 0; k < scene.lineCount(); k++) {
      Vec2 closest = scene.line(k).closestPoint(centre);
      room = Math.min(room, Math.hypot(x - closest.x(), y - closest.y()));
    }
    return Math.max(0, 1 - room / scene.circle(i).radius());
  }

  private double roomToWalls(double x, double y) {
    if (scene.bounds().isEmpty()) {
      return Double.POSITIVE_INFINITY;
    }
    Bounds b = scene.bounds().get();
    return Math.min(Math.min(x - b.xmin(), b.xmax() - x), Math.min(y - b.ymin(), b.ymax() - y));
  }

  private boolean isInside(double x, double y) {
    return roomToWalls(x, y) >= 0;
  }

  /** How many are outside of the bounds after that frame or later; NaN if the run did not end. */
  private double escaped(int from) {
    int count = 0;
    for (int i = 0; i < run.circles(); i++) {
      boolean inside = true;
      for (int frame = from; frame <= run.frames() && inside; frame++) {
        inside = isInside(run.x(frame, i), run.y(frame, i));
      }
      count += inside ? 0 : 1;
    }
    return run.failure().isPresent() ? Double.NaN : count;
  }

  /** NaN if the run did not end. */
  private double tunnelled() {
    int count = 0;
    for (int i = 0; i < run.circles(); i++) {
      boolean passed = false;
      for (int frame = 1; frame <= run.frames() && !passed; frame++) {
        passed = passesSomeLine(frame, i);
      }
      count += passed ? 1 : 0;
    }
    return run.failure().isPresent() ? Double.NaN : count;
  }

  private boolean passesSomeLine(int frame, int i) {
    double travel = MARGIN * Math.max(run.speed(frame - 1, i), run.speed(frame, i));
    for (int k = 0; k < scene.lineCount(); k++) {
      Line line = scene.line(k);
      if (isBetween(line, frame, i)
          && detour(line.ax(), line.ay(), frame, i) > travel
          && detour(line.bx(), line.by(), frame, i) > travel) {
        return true;
      }
    }
    return false;
  }

  /** Whether the places before and after a frame are strictly on two sides, the line between. */
  private boolean isBetween(Line line, int frame, int i) {
    double wx = line.bx() - line.ax();
    double wy = line.by() - line.ay();
    double px = run.x(frame - 1, i) - line.ax();
    double py = run.y(frame - 1, i) - line.ay();
    double vx = run.x(frame, i) - run.x(frame - 1, i);
    double vy = run.y(frame, i) - run.y(frame - 1, i);
    double before = wx * py - wy * px;
    double after = before + wx * vy - wy * vx;
    double share = before / (before - after);
    double along = wx * (px + share * vx) + wy * (py + share * vy);
    return before * after < 0 && along > 0 && along < wx * wx + wy * wy;
  }

  /** The shortest way between the two places that passes by an end of the line. */
  private double detour(double ex, double ey, int frame, int i) {
    return Math.hypot(run.x(frame - 1, i) - ex, run.y(frame - 1, i) - ey)
        + Math.hypot(run.x(frame, i) - ex, run.y(frame, i) - ey);
  }
}
