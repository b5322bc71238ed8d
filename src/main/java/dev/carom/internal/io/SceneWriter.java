// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.OutlinePoints;
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
    if (!scene.collide) {
      out.append("collide,0\n");
    }
    if (scene.hasGravity()) {
      begin("gravity");
      numbers(scene.gx, scene.gy);
      endRow();
    }
    ObstacleTable obstacles = scene.obstacles;
    double[] w = obstacles.walls;
    if (w != null) {
      begin("wall");
      numbers(w[Codes.LEFT], w[Codes.BOTTOM], w[Codes.RIGHT], w[Codes.TOP]);
      end(obstacles.boundsRestitution, obstacles.boundsTraits, obstacles.filter(Codes.LEFT));
    }
    for (ObstacleRows rows : obstacles.kinds) {
      for (int code = rows.first(); code < rows.end; code = rows.endOf(code)) {
        if (obstacles.isOutline(code)) {
          outline(obstacles, code);
        } else {
          begin(rows.name());
          numbers(rows.numbers(code));
        }
        velocity(obstacles.ux(code), obstacles.uy(code));
        end(obstacles.givenRestitution(code), rows.traits(code), obstacles.filter(code));
      }
    }
    for (int i = 0; i < scene.circleCount(); i++) {
      begin("circle");
      numbers(scene.x(i), scene.y(i), scene.radius(i), scene.vx(i), scene.vy(i));
      mass(scene.registry.mass(i));
      end(scene.restitution(i), scene.registry.traits(i), scene.registry.filter(i));
    }
  }

  private void outline(ObstacleTable obstacles, int first) {
    OutlinePoints outline = obstacles.outline(first);
    begin("outline");
    numbers(outline.xy());
    if (outline.isSolid()) {
      row.append(",solid=1");
    }
  }

  private void begin(String kind) {
    row.append(kind);
  }

  /**
   * Writes numbers. {@link Double#toString(double)} has enough digits to read back the same bits.
   */
  private void numbers(double... numbers) {
    for (double number : numbers) {
      row.append(',').append(number);
    }
  }

  private void velocity(double vx, double vy) {
    if (vx != 0 || vy != 0) {
      row.append(",vx=").append(vx).append(",vy=").append(vy);
    }
  }

  private void mass(double mass) {
    if (mass == Double.POSITIVE_INFINITY) {
      row.append(",inf");
    } else if (mass != 1) {
      row.append(',').append(mass);
    }
  }

  private void end(double restitution, int traits, long filter) throws IOException {
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
    if (FilterBits.category(filter) != FilterBits.category(FilterBits.DEFAULT)) {
      row.append(",category=").append(FilterBits.category(filter));
    }
    if (FilterBits.mask(filter) != FilterBits.mask(FilterBits.DEFAULT)) {
      row.append(",mask=").append(FilterBits.mask(filter));
    }
    endRow();
  }

  private void endRow() throws IOException {
    out.append(row.append('\n'));
    row.setLength(0);
  }
}
