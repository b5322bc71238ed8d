// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static java.nio.file.StandardOpenOption.CREATE;
import static java.nio.file.StandardOpenOption.WRITE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import dev.carom.bench.view.Look;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.io.File;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import javax.swing.JFrame;

/**
 * A window that a robot uses by keys and mouse. An answer of the window may take as long as a slow
 * and busy machine needs: a test waits {@link #until} it is there, never for a fixed time. {@code
 * -Dcarom.screenshots=DIR} keeps what was to be seen.
 */
public final class Screen {

  /** An assertion about a window. */
  public interface Claim {

    /** Throws anything while the window has not answered. */
    void check() throws Exception;
  }

  private static final long LIMIT_NANOS = TimeUnit.SECONDS.toNanos(30);
  private static final int PAUSE_MILLIS = 16;

  /** Locked while a window is open: one virtual machine at a time has the mouse and the keys. */
  private static final Path LOCK =
      Path.of(System.getProperty("java.io.tmpdir"), "carom-screen.lock");

  private final Robot robot = new Robot();
  private final FileChannel lock = FileChannel.open(LOCK, CREATE, WRITE);
  private final JFrame frame;

  private Screen(Callable<JFrame> window) throws Exception {
    lock.lock();
    robot.setAutoDelay(PAUSE_MILLIS);
    frame = get(() -> show(window));
  }

  private static JFrame show(Callable<JFrame> window) throws Exception {
    Look.install();
    JFrame frame = window.call();
    frame.setLocation(0, 0);
    frame.setVisible(true);
    return frame;
  }

  /**
   * Opens a window. Skips the test where there is no screen; {@code xvfb-run mvn ...} brings one.
   */
  public static Screen open(Callable<JFrame> window) throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "no screen: nothing can be opened");
    Screen screen = new Screen(window);
    try {
      screen.until(() -> assertThat(screen.frame.isFocused()).as("focused").isTrue());
      return screen;
    } catch (Exception e) {
      screen.close();
      throw e;
    }
  }

  public void close() throws Exception {
    EventQueue.invokeAndWait(frame::dispose);
    lock.close();
  }

  public JFrame frame() {
    return frame;
  }

  /** Asks on the thread of the window. */
  public static <T> T get(Callable<T> question) throws Exception {
    FutureTask<T> task = new FutureTask<>(question);
    EventQueue.invokeAndWait(task);
    return task.get();
  }

  /** Repeats a claim on the thread of the window until it holds, for half a minute at most. */
  public void until(Claim claim) throws Exception {
    long end = System.nanoTime() + LIMIT_NANOS;
    while (!holds(claim, System.nanoTime() < end)) {
      robot.delay(PAUSE_MILLIS);
    }
  }

  private static boolean holds(Claim claim, boolean inTime) throws Exception {
    try {
      return get(
          () -> {
            claim.check();
            return true;
          });
    } catch (ExecutionException e) {
      if (inTime) {
        return false;
      }
      throw e;
    }
  }

  public void hold(int key) {
    robot.keyPress(key);
  }

  public void let(int key) {
    robot.keyRelease(key);
  }

  public void type(int key) {
    hold(key);
    let(key);
  }

  public void move(Point to) {
    robot.mouseMove(to.x, to.y);
  }

  public void press(Point at) {
    move(at);
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
  }

  public void release() {
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
  }

  /** Waits until the window has handled all that has reached it. */
  public void settle() {
    robot.waitForIdle();
  }

  public void keep(String name) throws Exception {
    String folder = System.getProperty("carom.screenshots");
    if (folder != null) {
      settle();
      Files.createDirectories(Path.of(folder));
      File file = new File(folder, name + ".png");
      ImageIO.write(robot.createScreenCapture(frame.getBounds()), "png", file);
    }
  }
}
