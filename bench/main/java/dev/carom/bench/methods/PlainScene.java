// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Scene;

/** What the plain methods can play: lines and bounds; some of them circles that collide, too. */
public final class PlainScene {

  private PlainScene() {}

  /**
   * Refuses what a plain method has no code for.
   *
   * @param scene any scene
   * @return the scene
   * @throws UnsupportedOperationException if it has pegs or colliding circles
   */
  public static Scene check(Scene scene) {
    return checkObstacles(checkCircles(scene));
  }

  /**
   * Refuses circles that collide.
   *
   * @param scene any scene
   * @return the scene
   * @throws UnsupportedOperationException if its circles collide
   */
  public static Scene checkCircles(Scene scene) {
    refuse(scene.collide(), "its circles collide", "circles that ignore each other");
    return scene;
  }

  /**
   * Refuses obstacles that a plain method has no code for.
   *
   * @param scene any scene; its circles may collide
   * @return the scene
   * @throws UnsupportedOperationException if it has pegs
   */
  public static Scene checkObstacles(Scene scene) {
    refuse(scene.pegCount() > 0, "it has pegs", "lines and bounds");
    return scene;
  }

  private static void refuse(boolean condition, String why, String expected) {
    if (condition) {
      throw new UnsupportedOperationException(
          "this scene is not for this method: " + why + "; expected " + expected);
    }
  }
}
