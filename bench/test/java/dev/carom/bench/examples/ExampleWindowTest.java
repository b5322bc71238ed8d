// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Impact;
import dev.carom.bench.Screen;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.KeyEvent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Plays examples by keys and mouse. */
class ExampleWindowTest {

  private Screen screen;

  private void open(Example example) throws Exception {
    screen = Screen.open(() -> ExampleWindow.of("Test", example));
  }

  @AfterEach
  void close() throws Exception {
    if (screen != null) {
      screen.close();
    }
  }

  /** A point of the example, in shares from the left and from the top. */
  private Point at(double x, double y) throws Exception {
    Component view = Screen.get(() -> screen.frame().getContentPane().getComponent(0));
    Point corner = Screen.get(view::getLocationOnScreen);
    Dimension size = Screen.get(() -> view.getSize());
    return new Point(corner.x + (int) (x * size.width), corner.y + (int) (y * size.height));
  }

  @Test
  void thePaddleFollowsKeysAndMouse() throws Exception {
    Breakout game = new Breakout();
    open(game);
    screen.move(at(0.2, 0.5));
    screen.until(() -> assertThat(game.paddle).isBetween(30.0, 55.0));
    screen.hold(KeyEvent.VK_RIGHT);
    screen.until(() -> assertThat(game.paddle).isGreaterThan(150));
    screen.let(KeyEvent.VK_RIGHT);
    screen.keep("breakout");
  }

  @Test
  void aShotIsDrawnByTheMouse() throws Exception {
    Billiards table = new Billiards();
    open(table);
    Point from = at(0.6, 0.3);
    screen.press(from);
    screen.move(new Point(from.x - 100, from.y));
    screen.move(new Point(from.x - 200, from.y));
    screen.until(() -> assertThat(table.target()).map(Impact::id).contains(1));
    screen.keep("shot");
    screen.release();
    screen.until(() -> assertThat(table.world.x(1)).isNotEqualTo(0.75 * 2.54));
    screen.keep("break");
  }
}
