// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import dev.carom.bench.view.Look;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.File;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Plays examples by keys and mouse. Skipped where there is no screen; {@code xvfb-run mvn ...}
 * brings one. {@code -Dcarom.screenshots=DIR} keeps what was to be seen.
 */
class ExampleWindowTest {

  private Robot robot;
  private JFrame frame;

  @BeforeEach
  void findScreen() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "no screen: nothing can be opened");
    robot = new Robot();
    robot.setAutoDelay(60);
  }

  @AfterEach
  void close() throws Exception {
    if (frame != null) {
      EventQueue.invokeAndWait(frame::dispose);
    }
  }

  private void open(Example example) throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          Look.install();
          frame = ExampleWindow.of("Test", example);
          frame.setLocation(0, 0);
          frame.setVisible(true);
        });
    robot.waitForIdle();
    robot.delay(500);
  }

  private static <T> T get(Callable<T> question) throws Exception {
    FutureTask<T> task = new FutureTask<>(question);
    EventQueue.invokeAndWait(task);
    return task.get();
  }

  private void keep(String name) throws Exception {
    String folder = System.getProperty("carom.screenshots");
    if (folder != null) {
      robot.waitForIdle();
      File file = new File(folder, name + ".png");
      ImageIO.write(robot.createScreenCapture(frame.getBounds()), "png", file);
    }
  }

  /** A point of the example, in shares from the left and from the top. */
  private Point at(double x, double y) throws Exception {
    Component view = get(() -> frame.getContentPane().getComponent(0));
    Point corner = get(view::getLocationOnScreen);
    Dimension size = get(() -> view.getSize());
    return new Point(corner.x + (int) (x * size.width), corner.y + (int) (y * size.height));
  }

  @Test
  void thePaddleFollowsKeysAndMouse() throws Exception {
    Breakout game = new Breakout();
    open(game);
    robot.mouseMove(at(0.2, 0.5).x, at(0.2, 0.5).y);
    robot.delay(800);
    assertThat(get(() -> game.paddle)).isBetween(30.0, 55.0);
    robot.keyPress(KeyEvent.VK_RIGHT);
    robot.delay(1_500);
    robot.keyRelease(KeyEvent.VK_RIGHT);
    robot.delay(200);
    assertThat(get(() -> game.paddle)).isGreaterThan(150);
    keep("breakout");
  }

  @Test
  void aShotIsDrawnByTheMouse() throws Exception {
    Billiards table = new Billiards();
    open(table);
    Point from = at(0.6, 0.3);
    robot.mouseMove(from.x, from.y);
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    robot.mouseMove(from.x - 100, from.y);
    robot.mouseMove(from.x - 200, from.y);
    robot.delay(200);
    assertThat(get(() -> table.target().orElseThrow().id())).isEqualTo(1);
    keep("shot");
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    robot.delay(1_500);
    assertThat(get(() -> table.world.x(1))).isNotEqualTo(0.75 * 2.54);
    keep("break");
  }
}
