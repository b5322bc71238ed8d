// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/**
 * A scene in motion by one method. {@link #frame} is what is timed; the counts may cost time and
 * are asked for in replays that are not.
 */
public interface Method extends AutoCloseable {

  /** A count that a method does not tell. */
  int UNKNOWN = -1;

  /** Moves every circle by one frame, one unit of the scene's time. */
  void frame();

  /**
   * The impacts with lines and pegs in the last frame.
   *
   * @return at least 0; {@link #UNKNOWN} of a method that does not tell
   */
  default int impacts() {
    return UNKNOWN;
  }

  /**
   * The impacts with the walls of the bounds in the last frame.
   *
   * @return at least 0; {@link #UNKNOWN} of a method that does not tell
   */
  default int wallImpacts() {
    return UNKNOWN;
  }

  /**
   * The square roots of the last frame, those spent on finding and resolving impacts. No other
   * method may have moved since that frame began.
   *
   * @return at least 0; {@link #UNKNOWN} of a method that does not tell
   */
  default int squareRoots() {
    return UNKNOWN;
  }

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

  /**
   * How a circle moves at the end of the last frame.
   *
   * @param circle its number in the scene
   * @return the x component of its velocity, in units of length a frame
   */
  double vx(int circle);

  /**
   * How a circle moves at the end of the last frame.
   *
   * @param circle its number in the scene
   * @return the y component of its velocity, in units of length a frame
   */
  double vy(int circle);

  /**
   * How often, in the last frame, a circle and a line or peg were looked at together; iterations on
   * one pair count each. No other method may have moved since that frame began.
   *
   * @return at least 0; {@link #UNKNOWN} of a method that does not tell
   */
  default long pairTests() {
    return UNKNOWN;
  }

  /**
   * How often, in the last frame, more precision than a double was needed. No other method may have
   * moved since that frame began.
   *
   * @return at least 0; {@link #UNKNOWN} of a method that does not tell; 0 of one that has no other
   *     precision
   */
  default long fallbacks() {
    return 0;
  }

  /** Gives back what is not memory of the virtual machine. */
  @Override
  default void close() {}
}
