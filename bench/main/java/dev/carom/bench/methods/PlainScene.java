// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Scene;

/** What the plain methods can play: lines and bounds, elastic, circles that ignore each other. */
public final class PlainScene {

  private PlainScene() {}

  /**
   * Refuses what a plain method has no code for.
   *
   * @param scene any scene
   * @return the scene
   * @throws UnsupportedOperationException if it has pegs, colliding circles, or a restitution other
   *     than 1
   */
  public static Scene check(Scene scene) {
    refuse(scene.collide(), "its circles collide");
    refuse(scene.pegCount() > 0, "it has pegs");
    refuse(scene.boundsRestitution() != 1, "its bounds are not elastic");
    for (int i = 0; i < scene.circleCount(); i++) {
      refuse(scene.circleRestitution(i) != 1, "circle " + i + " is not elastic");
    }
    for (int k = 0; k < scene.lineCount(); k++) {
      refuse(scene.lineRestitution(k) != 1, "line " + k + " is not elastic");
    }
    return scene;
  }

  private static void refuse(boolean condition, String why) {
    if (condition) {
      throw new UnsupportedOperationException(
          "this scene is not for this method: "
              + why
              + "; expected elastic lines and bounds, and circles that ignore each other");
    }
  }
}
