// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import dev.carom.Circle;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.duel.Preset;
import dev.carom.bench.duel.Rival;
import dev.carom.bench.duel.ScoreLine;
import dev.carom.bench.experiment.Crosses;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import javax.swing.JCheckBox;
import javax.swing.JFrame;
import javax.swing.JMenu;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Opens the window and uses it by keys and mouse. Skipped where there is no screen; {@code xvfb-run
 * mvn ...} brings one. {@code -Dcarom.screenshots=DIR} keeps what was to be seen.
 */
class ViewWindowTest {

  private Robot robot;
  private Player player;
  private JFrame frame;

  @BeforeEach
  void open() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "no screen: nothing can be opened");
    robot = new Robot();
    robot.setAutoDelay(60);
    Scene scene = Crosses.canonical(1).scene();
    player = new Player(scene, 1);
    EventQueue.invokeAndWait(this::show);
    robot.waitForIdle();
    robot.delay(500);
  }

  private void show() {
    Look.install();
    Player.warmUp(player.scene());
    frame = ViewWindow.of("Test", player);
    frame.setLocation(0, 0);
    frame.setVisible(true);
  }

  @AfterEach
  void close() throws Exception {
    if (frame != null) {
      EventQueue.invokeAndWait(frame::dispose);
    }
  }

  private ViewPanel panel() {
    return (ViewPanel) frame.getContentPane().getComponent(0);
  }

  private static <T> T get(Callable<T> question) throws Exception {
    FutureTask<T> task = new FutureTask<>(question);
    EventQueue.invokeAndWait(task);
    return task.get();
  }

  private void type(int key) {
    robot.keyPress(key);
    robot.keyRelease(key);
    robot.waitForIdle();
  }

  private void press(Point at) {
    robot.mouseMove(at.x, at.y);
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
  }

  private void keep(String name) throws Exception {
    String folder = System.getProperty("carom.screenshots");
    if (folder != null) {
      robot.waitForIdle();
      File file = new File(folder, name + ".png");
      ImageIO.write(robot.createScreenCapture(frame.getBounds()), "png", file);
    }
  }

  @Test
  void runsByItsTimerAndStopsAtTheNextImpact() throws Exception {
    Point canvas = get(() -> panel().canvas().getLocationOnScreen());
    press(canvas); // a click outside of the scene gives the window the keys
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    type(KeyEvent.VK_SPACE);
    robot.delay(2_000);
    type(KeyEvent.VK_SPACE);
    double reached = get(() -> player.shown());
    assertThat(reached).isGreaterThan(5);
    assertThat(get(() -> player.isRunning())).isFalse();
    type(KeyEvent.VK_I);
    assertThat(get(() -> player.shown())).isGreaterThan(reached);
    type(KeyEvent.VK_N);
    keep("view");
  }

  /** By its menu and the keys of its layers; the window narrow, so that its tool bar wraps. */
  @Test
  void goesDarkAndNarrow() throws Exception {
    player.setRunning(true);
    robot.delay(1_000);
    robot.keyPress(KeyEvent.VK_CONTROL);
    type(KeyEvent.VK_D);
    robot.keyRelease(KeyEvent.VK_CONTROL);
    type(KeyEvent.VK_SPACE);
    type(KeyEvent.VK_N);
    type(KeyEvent.VK_A);
    type(KeyEvent.VK_G);
    JCheckBox normals = get(() -> ViewPanelTest.all(panel(), JCheckBox.class).get(1));
    assertThat(get(normals::isSelected)).isTrue();
    keep("dark");
    int row = get(() -> panel().getComponent(0).getHeight());
    EventQueue.invokeAndWait(() -> frame.setSize(560, 480));
    robot.delay(500);
    assertThat(get(() -> panel().getComponent(0).getHeight())).isGreaterThan(row);
    keep("narrow");
    EventQueue.invokeAndWait(() -> Look.set(false));
  }

  @Test
  void playsBesideAnotherMethodAndGoesBack() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          panel().play("Row", Preset.ROW.scene(), Preset.ROW.truth());
          panel().challenge(Rival.BOX2D);
        });
    type(KeyEvent.VK_SPACE);
    robot.delay(3_000);
    type(KeyEvent.VK_SPACE);
    keep("duel");
    assertThat(get(() -> panel().scores().scores().get(0))).noneMatch(ScoreLine::bad);
    assertThat(get(() -> panel().scores().scores().get(1))).anyMatch(ScoreLine::bad);
    for (int i = 0; i < 5; i++) {
      type(KeyEvent.VK_LEFT);
    }
    int frame = get(() -> panel().arena().frame());
    assertThat(get(() -> panel().arena().duel().carom(frame).x(3)))
        .isEqualTo(get(() -> player.scene().circle(3).x()));
    type(KeyEvent.VK_B);
    keep("duel-next");
    assertThat(get(() -> panel().arena().duel().rival())).isEqualTo(Rival.DYN4J);
  }

  @Test
  void showsTheScenesOfItsMenu() throws Exception {
    JMenu scenes = get(() -> frame.getJMenuBar().getMenu(1));
    JMenu maps = get(() -> (JMenu) scenes.getItem(2));
    JMenu corners = get(() -> (JMenu) maps.getItem(2));
    JMenu row = get(() -> (JMenu) corners.getItem(1));
    EventQueue.invokeAndWait(() -> row.getItem(2).doClick());
    EventQueue.invokeAndWait(() -> panel().challenge(Rival.DYN4J));
    type(KeyEvent.VK_SPACE);
    robot.delay(600);
    type(KeyEvent.VK_SPACE);
    assertThat(get(() -> frame.getTitle())).startsWith("opening of the corner, degrees: ");
    keep("map");
    Point bar = get(() -> frame.getJMenuBar().getMenu(1).getLocationOnScreen());
    press(new Point(bar.x + 10, bar.y + 8));
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    robot.delay(400);
    type(KeyEvent.VK_DOWN);
    type(KeyEvent.VK_DOWN);
    type(KeyEvent.VK_RIGHT);
    robot.delay(400);
    keep("menu");
    type(KeyEvent.VK_ESCAPE);
    type(KeyEvent.VK_ESCAPE);
    type(KeyEvent.VK_ESCAPE);
  }

  @Test
  void tellsItsKeys() throws Exception {
    robot.keyPress(KeyEvent.VK_SHIFT);
    type(KeyEvent.VK_SLASH); // the question mark of the display's keyboard
    robot.keyRelease(KeyEvent.VK_SHIFT);
    robot.delay(500);
    keep("help");
    assertThat(get(() -> openDialogs())).isEqualTo(1);
    type(KeyEvent.VK_ENTER);
    robot.delay(300);
    assertThat(get(() -> openDialogs())).isZero();
  }

  private int openDialogs() {
    return (int) Arrays.stream(frame.getOwnedWindows()).filter(Window::isVisible).count();
  }

  @Test
  void showsWhereABadFileIsWrongAndAsksBeforeAFileIsReplaced(@TempDir Path folder)
      throws Exception {
    Path bad = folder.resolve("bad.csv");
    Files.writeString(bad, "circle,100,100,10,1,1\nline,1,2,x,4\n");
    SceneFiles files = get(() -> new SceneFiles(panel(), new SwingDialogs(frame)));
    EventQueue.invokeLater(() -> files.open(bad));
    robot.delay(700);
    assertThat(get(() -> openDialogs())).isEqualTo(1);
    keep("bad-file");
    type(KeyEvent.VK_ENTER);
    robot.delay(300);
    assertThat(get(() -> player.scene().circleCount())).as("the old scene").isEqualTo(100);
    EventQueue.invokeLater(() -> files.save(bad));
    robot.delay(700);
    keep("replace");
    type(KeyEvent.VK_ENTER);
    robot.delay(300);
    assertThat(bad).content().startsWith("circle,100,100,10,1,1");
    EventQueue.invokeLater(() -> files.save(bad));
    robot.delay(700);
    type(KeyEvent.VK_TAB);
    type(KeyEvent.VK_SPACE);
    robot.delay(500);
    assertThat(Scene.read(bad).circleCount()).isEqualTo(100);
    assertThat(get(() -> frame.getTitle())).isEqualTo("bad.csv - Carom");
  }

  /** On a machine that is busy the mouse may rest too long before it lets go. */
  @Test
  void throwsACircle() throws Exception {
    Vec2 before = get(() -> player.scene().velocity(99));
    robot.setAutoDelay(16);
    Vec2 after = before;
    for (int attempt = 0; attempt < 5 && after.equals(before); attempt++) {
      Point corner = get(() -> panel().canvas().getLocationOnScreen());
      Point2D at = get(this::lastCircle);
      Point circle = new Point(corner.x + (int) at.getX(), corner.y + (int) at.getY());
      press(circle);
      for (int i = 1; i <= 10; i++) {
        robot.mouseMove(circle.x + 6 * i, circle.y);
      }
      robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
      robot.waitForIdle();
      after = get(() -> player.scene().velocity(99));
    }
    assertThat(after.x()).isBetween(0.5, 50.0);
    assertThat(Math.abs(after.y())).isLessThan(0.01);
  }

  @Test
  void zoomsThrowsAndAdds() throws Exception {
    Point corner = get(() -> panel().canvas().getLocationOnScreen());
    Dimension size = get(() -> panel().canvas().getSize());
    Point middle = new Point(corner.x + size.width / 2, corner.y + size.height / 2);
    robot.mouseMove(middle.x, middle.y);
    robot.mouseWheel(-6);
    robot.delay(300);
    type(KeyEvent.VK_2);
    press(middle);
    robot.mouseMove(middle.x + 60, middle.y - 40);
    robot.mouseMove(middle.x + 160, middle.y - 90);
    robot.delay(300);
    keep("draft");
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    robot.waitForIdle();
    assertThat(get(() -> player.scene().circleCount())).isEqualTo(101);
    type(KeyEvent.VK_1);
    robot.mouseMove(middle.x, middle.y);
    robot.delay(300);
    assertThat(get(() -> panel().canvas().hovered())).isNotEmpty();
    keep("hover");
  }

  @Test
  void dragsACircleByTheMouse() throws Exception {
    Point corner = get(() -> panel().canvas().getLocationOnScreen());
    Point2D at = get(this::lastCircle);
    Point circle = new Point(corner.x + (int) at.getX(), corner.y + (int) at.getY());
    Scene before = get(() -> player.scene());
    press(circle);
    robot.mouseMove(circle.x + 30, circle.y + 40);
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    robot.waitForIdle();
    Scene after = get(() -> player.scene());
    assertThat(after.circle(99).x()).isGreaterThan(before.circle(99).x());
    assertThat(after.circle(99).y()).isLessThan(before.circle(99).y());
    keep("dragged");
  }

  private Point2D lastCircle() {
    SceneCanvas canvas = panel().canvas();
    Circle last = player.scene().circle(99);
    AffineTransform map =
        canvas.painter().transform(new Rectangle(canvas.getWidth(), canvas.getHeight()));
    return map.transform(new Point2D.Double(last.x(), last.y()), null);
  }
}
