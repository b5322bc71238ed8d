// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/**
 * A scene in motion by one method. {@link #frame} is what is timed; the counts may cost time and
 * are asked for in replays that are not.
 */
public interface Method {

  /** Moves every circle by one frame, one unit of the scene's time. */
  void frame();

  /**
   * The impacts with lines and pegs in the last frame.
   *
   * @return at least 0
   */
  int impacts();

  /**
   * The impacts with the walls of the bounds in the last frame.
   *
   * @return at least 0
   */
  int wallImpacts();

  /**
   * The square roots of the last frame, those spent on finding and resolving impacts. No other
   * method may have moved since that frame began.
   *
   * @return at least 0
   */
  int squareRoots();

  /**
   * Where a circle is at the end of the last frame.
   *
   * @param circle its number in the scene
   * @return the x coordinate of its centre
   */
  double x(int circle);

  /**
   * Where a circle is at the end of the last frame.
   *
   * @param circle its number in the scene
   * @return the y coordinate of its centre
   */
  double y(int circle);
}
