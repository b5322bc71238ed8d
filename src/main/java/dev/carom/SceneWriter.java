// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.io.IOException;

/** Writes the rows of a scene file. */
final class SceneWriter {

  private final Appendable out;
  private final StringBuilder row = new StringBuilder();

  SceneWriter(Appendable out) {
    this.out = out;
  }

  void write(Scene scene) throws IOException {
    if (scene.collide) {
      out.append("collide,1\n");
    }
    double[] w = scene.walls;
    if (w != null) {
      begin("wall", w[Obstacles.LEFT], w[Obstacles.BOTTOM], w[Obstacles.RIGHT], w[Obstacles.TOP]);
      end(scene, ObstacleKind.WALL, 0);
    }
    for (int i = 0; i < scene.lineCount(); i++) {
      Line line = scene.line(i);
      begin("line", line.ax(), line.ay(), line.bx(), line.by());
      end(scene, ObstacleKind.LINE, i);
    }
    for (int i = 0; i < scene.pegCount(); i++) {
      Circle peg = scene.peg(i);
      begin("peg", peg.x(), peg.y(), peg.radius());
      end(scene, ObstacleKind.PEG, i);
    }
    for (int i = 0; i < scene.circleCount(); i++) {
      Circle c = scene.circle(i);
      Vec2 v = scene.velocity(i);
      begin("circle", c.x(), c.y(), c.radius(), v.x(), v.y());
      mass(scene.mass(i));
      end(scene, ObstacleKind.CIRCLE, i);
    }
  }

  /** {@link Double#toString(double)} has digits enough to read back the same bits. */
  private void begin(String kind, double... numbers) {
    row.append(kind);
    for (double number : numbers) {
      row.append(',').append(number);
    }
  }

  private void mass(double mass) {
    if (mass == Double.POSITIVE_INFINITY) {
      row.append(",inf");
    } else if (mass != 1) {
      row.append(',').append(mass);
    }
  }

  private void end(Scene scene, ObstacleKind kind, int i) throws IOException {
    double restitution = scene.restitution(kind, i);
    int response = Traits.response(scene.traits(kind, i));
    if (restitution != 1) {
      row.append(",restitution=").append(restitution);
    }
    if (response != Traits.BOUNCE) {
      row.append(",response=").append(SceneRowKind.RESPONSES.get(response));
    }
    if (kind == ObstacleKind.LINE && scene.oneWay(i)) {
      row.append(",oneway=1");
    }
    out.append(row.append('\n'));
    row.setLength(0);
  }
}
