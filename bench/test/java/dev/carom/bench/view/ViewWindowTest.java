// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import static dev.carom.bench.Screen.get;
import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLaf;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.Screen;
import dev.carom.bench.duel.Preset;
import dev.carom.bench.duel.Rival;
import dev.carom.bench.duel.ScoreLine;
import dev.carom.bench.experiment.Crosses;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import javax.swing.JCheckBox;
import javax.swing.JMenu;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Opens the window and uses it by keys and mouse. */
class ViewWindowTest {

  private Player player;
  private Screen screen;

  @BeforeEach
  void open() throws Exception {
    player = new Player(Crosses.canonical(1).scene(), 1);
    screen = Screen.open(() -> ViewWindow.of("Test", player));
    screen.until(() -> assertThat(player.shown()).as("it starts moving").isPositive());
    EventQueue.invokeAndWait(() -> player.setRunning(false));
  }

  @AfterEach
  void close() throws Exception {
    if (screen != null) {
      screen.close();
    }
  }

  private ViewPanel panel() {
    return (ViewPanel) screen.frame().getContentPane().getComponent(0);
  }

  @Test
  void runsByItsTimerAndStopsAtTheNextImpact() throws Exception {
    screen.press(corner()); // a click outside of the scene gives the window the keys
    screen.release();
    runUntil(() -> assertThat(player.shown()).isGreaterThan(5));
    double reached = get(() -> player.shown());
    screen.type(KeyEvent.VK_I);
    screen.until(() -> assertThat(player.shown()).isGreaterThan(reached));
    screen.type(KeyEvent.VK_N);
    screen.keep("view");
  }

  private void runUntil(Screen.Claim claim) throws Exception {
    screen.type(KeyEvent.VK_SPACE);
    screen.until(claim);
    screen.type(KeyEvent.VK_SPACE);
    screen.until(() -> assertThat(player.isRunning()).isFalse());
  }

  /** By its menu and the keys of its layers; the window narrow, so that its tool bar wraps. */
  @Test
  void goesDarkAndNarrow() throws Exception {
    runUntil(() -> assertThat(player.shown()).isGreaterThan(5));
    screen.hold(KeyEvent.VK_CONTROL);
    screen.type(KeyEvent.VK_D);
    screen.let(KeyEvent.VK_CONTROL);
    screen.until(() -> assertThat(FlatLaf.isLafDark()).isTrue());
    screen.type(KeyEvent.VK_N);
    screen.type(KeyEvent.VK_A);
    screen.type(KeyEvent.VK_G);
    JCheckBox normals = get(() -> ViewPanelTest.all(panel(), JCheckBox.class).get(1));
    screen.until(() -> assertThat(normals.isSelected()).isTrue());
    screen.keep("dark");
    int row = get(() -> panel().getComponent(0).getHeight());
    EventQueue.invokeAndWait(() -> screen.frame().setSize(560, 480));
    screen.until(() -> assertThat(panel().getComponent(0).getHeight()).isGreaterThan(row));
    screen.keep("narrow");
  }

  @Test
  void playsBesideAnotherMethodAndGoesBack() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          panel().play("Row", Preset.ROW.scene(), Preset.ROW.truth());
          panel().challenge(Rival.BOX2D);
        });
    runUntil(() -> assertThat(panel().scores().scores().get(1)).anyMatch(ScoreLine::bad));
    screen.keep("duel");
    assertThat(get(() -> panel().scores().scores().get(0))).noneMatch(ScoreLine::bad);
    int reached = get(() -> panel().arena().frame());
    for (int i = 0; i < 5; i++) {
      screen.type(KeyEvent.VK_LEFT);
    }
    screen.until(() -> assertThat(panel().arena().frame()).isEqualTo(reached - 5));
    assertThat(get(() -> panel().arena().duel().carom(reached - 5).x(3)))
        .isEqualTo(get(() -> ((Circle) player.scene().shape(Kind.CIRCLE, 3)).x()));
    screen.type(KeyEvent.VK_B);
    screen.until(() -> assertThat(panel().arena().duel().rival()).isEqualTo(Rival.DYN4J));
    screen.keep("duel-next");
  }

  @Test
  void showsTheScenesOfItsMenu() throws Exception {
    JMenu scenes = get(() -> screen.frame().getJMenuBar().getMenu(1));
    JMenu maps = get(() -> (JMenu) scenes.getItem(2));
    JMenu corners = get(() -> (JMenu) maps.getItem(2));
    JMenu row = get(() -> (JMenu) corners.getItem(1));
    EventQueue.invokeAndWait(() -> row.getItem(2).doClick());
    EventQueue.invokeAndWait(() -> panel().challenge(Rival.DYN4J));
    runUntil(() -> assertThat(player.shown()).isGreaterThan(5));
    assertThat(get(() -> screen.frame().getTitle())).startsWith("opening of the corner, degrees: ");
    screen.keep("map");
    Point bar = get(scenes::getLocationOnScreen);
    screen.press(new Point(bar.x + 10, bar.y + 8));
    screen.release();
    screen.until(() -> assertThat(scenes.isPopupMenuVisible()).isTrue());
    screen.type(KeyEvent.VK_DOWN);
    screen.type(KeyEvent.VK_DOWN);
    screen.type(KeyEvent.VK_RIGHT);
    JMenu failures = get(() -> (JMenu) scenes.getItem(1));
    screen.until(() -> assertThat(failures.isPopupMenuVisible()).isTrue());
    screen.keep("menu");
    for (int i = 0; i < 3; i++) {
      screen.type(KeyEvent.VK_ESCAPE);
    }
    screen.until(() -> assertThat(scenes.isPopupMenuVisible()).isFalse());
  }

  @Test
  void dragsACircleByTheMouse() throws Exception {
    Point circle = lastCircle();
    Scene before = get(() -> player.scene());
    screen.press(circle);
    screen.move(new Point(circle.x + 30, circle.y + 40));
    screen.release();
    screen.until(
        () -> {
          Scene after = player.scene();
          assertThat(((Circle) after.shape(Kind.CIRCLE, 99)).x())
              .isGreaterThan(((Circle) before.shape(Kind.CIRCLE, 99)).x());
          assertThat(((Circle) after.shape(Kind.CIRCLE, 99)).y())
              .isLessThan(((Circle) before.shape(Kind.CIRCLE, 99)).y());
        });
    screen.keep("dragged");
  }

  private Point corner() throws Exception {
    return get(() -> panel().canvas().getLocationOnScreen());
  }

  private Point lastCircle() throws Exception {
    return get(
        () -> {
          SceneCanvas canvas = panel().canvas();
          Circle last = (Circle) player.scene().shape(Kind.CIRCLE, 99);
          Rectangle area = new Rectangle(canvas.getWidth(), canvas.getHeight());
          Point2D at = new Point2D.Double(last.x(), last.y());
          canvas.painter().transform(area).transform(at, at);
          Point corner = canvas.getLocationOnScreen();
          return new Point(corner.x + (int) at.getX(), corner.y + (int) at.getY());
        });
  }
}
