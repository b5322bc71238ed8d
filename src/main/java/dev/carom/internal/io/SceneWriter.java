// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
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
      begin("wall", w[Codes.LEFT], w[Codes.BOTTOM], w[Codes.RIGHT], w[Codes.TOP]);
      end(scene.boundsRestitution, scene.boundsTraits);
    }
    for (int i = 0; i < scene.lineCount(); i++) {
      int k = SceneData.lineAt(i);
      double[] l = scene.lines;
      begin(
          "line",
          l[k + ObstacleTable.AX],
          l[k + ObstacleTable.AY],
          l[k + ObstacleTable.BX],
          l[k + ObstacleTable.BY]);
      end(scene.lineRestitution(i), ContactFlags.of(scene.lineTraits, i));
    }
    for (int i = 0; i < scene.pegCount(); i++) {
      int k = SceneData.pegAt(i);
      double[] p = scene.pegs;
      begin("peg", p[k + ObstacleTable.X], p[k + ObstacleTable.Y], p[k + ObstacleTable.RADIUS]);
      end(scene.pegRestitution(i), ContactFlags.of(scene.pegTraits, i));
    }
    for (int i = 0; i < scene.circleCount(); i++) {
      begin("circle", scene.x(i), scene.y(i), scene.radius(i), scene.vx(i), scene.vy(i));
      mass(scene.masses[i]);
      end(scene.restitution(i), ContactFlags.of(scene.circleTraits, i));
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
    int response = ContactFlags.response(traits);
    if (response != ContactFlags.BOUNCE) {
      row.append(",response=").append(SceneRowKind.RESPONSES.get(response));
    }
    if (ContactFlags.isOneWay(traits)) {
      row.append(",oneway=1");
    }
    out.append(row.append('\n'));
    row.setLength(0);
  }
}
