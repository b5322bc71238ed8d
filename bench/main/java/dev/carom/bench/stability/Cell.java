// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.reference.Reference;

/**
 * A small scene with a fixed run, and what really happens in it.
 *
 * @param scene the scene at time 0
 * @param truth its course, of as many frames as are played; null if impacts pile up so that none
 *     was found
 * @param fence where no circle can be
 * @param pilesUp whether impacts without end pile up
 */
record Cell(Scene scene, Reference truth, Fence fence, boolean pilesUp) {

  /** The accuracy that the library states: so many roundings times the conditioning. */
  private static final double ROUNDINGS = 4 * 0x1p-53;

  CellLimit limit() {
    if (pilesUp || truth == null) {
      return CellLimit.PILE_UP;
    }
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      double most =
          Math.log10(CellJudge.RIGHT * ((Circle) scene.shape(Kind.CIRCLE, i)).radius() / ROUNDINGS);
      for (int frame = 1; frame <= truth.frames(); frame++) {
        if (truth.log10Conditioning(frame, i) > most) {
          return CellLimit.DOUBLES;
        }
      }
    }
    return CellLimit.NONE;
  }
}
