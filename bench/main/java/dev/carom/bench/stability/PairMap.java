// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.bench.reference.Truth;

/** A circle that squeezes a lighter one against a line. */
final class PairMap {

  private static final double[] RESTITUTIONS = {
    0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99, 1
  };

  private static final double RADIUS = 10;

  /** Distance of the first circle's face from the line, without the diameter of the second one. */
  private static final double ROOM = 40;

  /** Distance of the second circle from the line. */
  private static final double GAP = 25;

  /** Offset of the second circle to the side: hits are not quite head-on. */
  private static final double ASIDE = 0.5;

  /** At 1 a frame; were the first circle not slowed down, a room of 1 would be left. */
  private static final int FRAMES = 39;

  private PairMap() {}

  static FailureMap map() {
    return new FailureMap(
        "mass",
        "ratio of two masses and restitution",
        "A heavy ball pushes a lighter one, which rests before a line, at a tenth of a radius a frame.",
        Axis.decades("mass of the one that flies, in masses of the other", 0, 12, 1),
        Axis.plain("restitution", RESTITUTIONS),
        PairMap::cell);
  }

  private static Cell cell(double ratio, double restitution) {
    // The product of the two is the pair's.
    double each = Math.sqrt(restitution);
    SceneBuilder setup = Scene.builder().line(0, -30 * RADIUS, 0, 30 * RADIUS);
    setup.circle(ROOM + 3 * RADIUS, 0, RADIUS, -1, 0).mass(ratio).restitution(each);
    setup.circle(GAP + RADIUS, ASIDE, RADIUS, 0, 0).restitution(each);
    Scene scene = setup.build();
    Truth truth = Truth.of(scene, FRAMES, () -> {});
    return new Cell(scene, truth, (x, y) -> x < 0, false);
  }
}
