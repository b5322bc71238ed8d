// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import static dev.carom.Kind.LINE;
import static dev.carom.Kind.PEG;

import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.charts.Sides;
import java.util.stream.IntStream;

/**
 * Scenes that the plain methods can play: lines at rest and bounds, without gravity. Some methods
 * also play pegs, or circles that collide.
 */
public final class PlainScene {

  private PlainScene() {}

  /**
   * Refuses circles that collide or fall, and obstacles that move.
   *
   * @throws UnsupportedOperationException if its circles collide, a line or a peg moves, or there
   *     is gravity
   */
  public static Scene checkCircles(Scene scene) {
    refuse(collides(scene), "its circles collide", "circles that ignore each other");
    return checkRest(checkStraight(scene));
  }

  /**
   * Refuses gravity.
   *
   * @throws UnsupportedOperationException if there is gravity
   */
  public static Scene checkStraight(Scene scene) {
    refuse(!isStraight(scene), "it has gravity", "circles that fly straight");
    return scene;
  }

  /** Whether circles fly straight, that is, without gravity. */
  public static boolean isStraight(Scene scene) {
    return scene.gravity().equals(Vec2.ZERO);
  }

  /**
   * Refuses obstacles that a plain method has no code for.
   *
   * @param scene any scene; its circles may collide
   * @throws UnsupportedOperationException if it has pegs, or a line moves
   */
  public static Scene checkObstacles(Scene scene) {
    refuse(scene.count(Kind.PEG) > 0, "it has pegs", "lines and bounds");
    return checkRest(scene);
  }

  /**
   * Refuses obstacles that move.
   *
   * @throws UnsupportedOperationException if a line or a peg moves, or a side of the bounds is
   *     open, or there is an outline
   */
  public static Scene checkRest(Scene scene) {
    refuse(isOpen(scene), "its bounds are open", "four walls or none");
    refuse(Sides.areJoined(scene), "it has outlines", "single lines");
    refuse(!isAtRest(scene), "lines or pegs move", "obstacles at rest");
    return scene;
  }

  /** Whether the bounds have open sides. */
  public static boolean isOpen(Scene scene) {
    return scene.bounds().isPresent() && scene.count(Kind.WALL) < 4;
  }

  /** Whether no line or peg moves. */
  public static boolean isAtRest(Scene scene) {
    return rest(scene, LINE, scene.count(Kind.LINE)) && rest(scene, PEG, scene.count(Kind.PEG));
  }

  /** The unit vector from the start to the end of a line; (1, 0) if they are one point. */
  static Vec2 direction(Line line) {
    double l = line.length();
    return l > 0
        ? new Vec2((line.bx() - line.ax()) / l, (line.by() - line.ay()) / l)
        : new Vec2(1, 0);
  }

  private static boolean rest(Scene scene, Kind kind, int count) {
    return IntStream.range(0, count).allMatch(i -> scene.velocity(kind, i).equals(Vec2.ZERO));
  }

  private static void refuse(boolean condition, String why, String expected) {
    if (condition) {
      throw new UnsupportedOperationException(
          "this scene is not for this method: " + why + "; expected " + expected);
    }
  }

  /**
   * Whether circles of a scene can collide: there are several, and they do not ignore each other.
   */
  public static boolean collides(Scene scene) {
    return scene.collide() && scene.count(Kind.CIRCLE) > 1;
  }
}
