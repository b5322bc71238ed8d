// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.Obstacles;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.Traits;
import java.io.IOException;

/** Writes the rows of a scene file. */
final class SceneWriter {

  private final Appendable out;
  private final StringBuilder row = new StringBuilder();

  SceneWriter(Appendable out) {
    this.out = out;
  }

  void write(SceneData scene) throws IOException {
    if (scene.collide) {
      out.append("collide,1\n");
    }
    double[] w = scene.walls;
    if (w != null) {
      begin("wall", w[Obstacles.LEFT], w[Obstacles.BOTTOM], w[Obstacles.RIGHT], w[Obstacles.TOP]);
      end(scene.boundsRestitution, scene.boundsTraits);
    }
    for (int i = 0; i < scene.lineCount(); i++) {
      int k = SceneData.lineAt(i);
      double[] l = scene.lines;
      begin(
          "line",
          l[k + Obstacles.AX],
          l[k + Obstacles.AY],
          l[k + Obstacles.BX],
          l[k + Obstacles.BY]);
      end(scene.lineRestitution(i), Traits.of(scene.lineTraits, i));
    }
    for (int i = 0; i < scene.pegCount(); i++) {
      int k = SceneData.pegAt(i);
      double[] p = scene.pegs;
      begin("peg", p[k + Obstacles.X], p[k + Obstacles.Y], p[k + Obstacles.RADIUS]);
      end(scene.pegRestitution(i), Traits.of(scene.pegTraits, i));
    }
    for (int i = 0; i < scene.circleCount(); i++) {
      begin("circle", scene.x(i), scene.y(i), scene.radius(i), scene.vx(i), scene.vy(i));
      mass(scene.masses[i]);
      end(scene.restitution(i), Traits.of(scene.circleTraits, i));
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

  private void end(double restitution, int traits) throws IOException {
    if (restitution != 1) {
      row.append(",restitution=").append(restitution);
    }
    int response = Traits.response(traits);
    if (response != Traits.BOUNCE) {
      row.append(",response=").append(SceneRowKind.RESPONSES.get(response));
    }
    if (Traits.isOneWay(traits)) {
      row.append(",oneway=1");
    }
    out.append(row.append('\n'));
    row.setLength(0);
  }
}
