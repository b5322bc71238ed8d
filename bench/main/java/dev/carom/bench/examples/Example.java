// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Vec2;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;

/** Something that goes on frame by frame and can be drawn, in a window or without one. */
public interface Example {

  /** The frames of a second. */
  int FRAMES = 60;

  /** Goes on by one frame. */
  void frame();

  /**
   * Draws the present.
   *
   * @param area where on it, in pixels
   */
  void draw(Graphics2D g, Rectangle2D area);

  /** The size that suits it: in pixels. */
  default Dimension size() {
    return new Dimension(840, 640);
  }

  /** The instruction for a player: one line, to stand under the picture. */
  String hint();

  /**
   * The mouse moved; examples without a player take no notice.
   *
   * @param at where, in shares of the width from the left and of the height from the bottom
   */
  default void point(Vec2 at) {}

  /** The mouse was pressed. */
  default void press() {}

  /** The mouse was released. */
  default void release() {}

  /**
   * A key was pressed or released.
   *
   * @param code as {@link java.awt.event.KeyEvent} has it
   * @param down whether it was pressed
   */
  default void key(int code, boolean down) {}
}
