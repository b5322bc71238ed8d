// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.ObstacleKind;
import dev.carom.Scene;
import dev.carom.World;

/**
 * Watches what must not happen: a centre whose flight from one impact to the next crosses a line,
 * circles outside of the bounds, and circles deep inside of each other. Where a centre was at an
 * impact follows from the log: the contact point and the radius along the normal.
 */
final class Guard {

  /** How deep circles may be inside of each other by rounding, in radii. */
  private static final double DEPTH = 1e-9;

  private final Scene scene;
  private final World world;
  private final LineMap lines;
  private final double[] places;
  private long crossings;

  Guard(Scene scene, World world) {
    this.scene = scene;
    this.world = world;
    lines = new LineMap(scene);
    places = new double[2 * scene.circleCount()];
    for (int i = 0; i < scene.circleCount(); i++) {
      places[2 * i] = scene.circle(i).x();
      places[2 * i + 1] = scene.circle(i).y();
    }
  }

  /** Of circles through lines, so far. */
  long crossings() {
    return crossings;
  }

  /** Looks at the flights that ended in the last step. */
  void watch(ImpactLog log) {
    if (scene.lineCount() == 0) {
      return;
    }
    for (int row = 0; row < log.size(); row++) {
      int i = log.circle(row);
      double r = world.radius(i);
      land(i, log.x(row) + r * log.nx(row), log.y(row) + r * log.ny(row));
      if (log.kind(row) == ObstacleKind.CIRCLE) {
        int j = log.id(row);
        double s = world.radius(j);
        land(j, log.x(row) - s * log.nx(row), log.y(row) - s * log.ny(row));
      }
    }
  }

  private void land(int i, double x, double y) {
    crossings += lines.isCrossed(places[2 * i], places[2 * i + 1], x, y) ? 1 : 0;
    places[2 * i] = x;
    places[2 * i + 1] = y;
  }

  /** How many centres are outside of the bounds now. */
  int outside() {
    int count = 0;
    for (int i = 0; i < world.circleCount(); i++) {
      count += PlaceCheck.beyond(world, i) < world.radius(i) ? 0 : 1;
    }
    return count;
  }

  /** How many pairs of circles that collide are inside of each other now. */
  int overlaps() {
    int count = 0;
    for (int i = 0; scene.collide() && i < world.circleCount(); i++) {
      for (int j = 0; j < i; j++) {
        double dx = world.x(i) - world.x(j);
        double dy = world.y(i) - world.y(j);
        double reach = (world.radius(i) + world.radius(j)) * (1 - DEPTH);
        count += dx * dx + dy * dy < reach * reach ? 1 : 0;
      }
    }
    return count;
  }
}
