// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import dev.carom.ObstacleKind;
import dev.carom.Scene;
import dev.carom.bench.view.ScenePainter.Layer;
import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JSlider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Uses the panel without a screen: its buttons, its slider, the mouse, and what it paints. */
class ViewPanelTest {

  private static final Scene SCENE =
      Scene.builder()
          .bounds(0, 0, 100, 60)
          .line(20, 10, 60, 10)
          .restitution(0.5)
          .circle(50, 30, 10, 8, 0)
          .build();

  private final Player player = new Player(SCENE, 1);
  private final ViewPanel panel = new ViewPanel(player);

  @TempDir private Path folder;

  @BeforeEach
  void layOut() {
    panel.setSize(panel.getPreferredSize());
    layOut(panel);
  }

  private static void layOut(Container container) {
    container.doLayout();
    for (Component child : container.getComponents()) {
      if (child instanceof Container inner) {
        layOut(inner);
      }
    }
  }

  private <T> List<T> all(Class<T> type) {
    return all(panel, type);
  }

  /** The components of a type, at any depth. */
  static <T> List<T> all(Container container, Class<T> type) {
    List<T> found = new ArrayList<>();
    collect(container, type, found);
    return found;
  }

  private static <T> void collect(Container container, Class<T> type, List<T> found) {
    for (Component child : container.getComponents()) {
      if (type.isInstance(child)) {
        found.add(type.cast(child));
      } else if (child instanceof Container inner) {
        collect(inner, type, found);
      }
    }
  }

  private JButton button(String text) {
    return all(JButton.class).stream().filter(b -> text.equals(b.getText())).findFirst().get();
  }

  /** What the canvas shows. */
  private int[] paint() {
    SceneCanvas canvas = panel.canvas();
    BufferedImage image =
        new BufferedImage(canvas.getWidth(), canvas.getHeight(), BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    canvas.paint(g);
    g.dispose();
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  @Test
  void runsAndPauses() {
    button("Run").doClick();
    panel.tick();
    panel.tick();
    assertThat(panel.status()).startsWith("time 2.000, 0 impacts; circles that ignore each other");
    button("Pause").doClick();
    panel.tick();
    assertThat(player.shown()).isEqualTo(2);
    button("Frame").doClick();
    assertThat(player.shown()).isEqualTo(3);
    button("Impact").doClick();
    assertThat(panel.status()).startsWith("time 5.000, 1 impacts");
    button("Restart").doClick();
    assertThat(player.end()).isZero();
    all(JComboBox.class).get(0).setSelectedItem(10.0);
    button("Run").doClick();
    panel.tick();
    assertThat(player.shown()).isEqualTo(10);
  }

  @Test
  void scrubs() {
    button("Impact").doClick();
    button("Impact").doClick();
    JSlider slider = all(JSlider.class).get(0);
    assertThat(slider.getValue()).isEqualTo(slider.getMaximum());
    slider.setValue(slider.getMaximum() / 3);
    assertThat(panel.status()).startsWith("time 4.999 of 15.000 (past)");
    assertThat(player.end()).isEqualTo(15);
  }

  @ParameterizedTest
  @EnumSource
  void showsEachLayer(Layer layer) {
    button("Impact").doClick();
    String name = layer.name();
    JCheckBox box =
        all(JCheckBox.class).stream()
            .filter(b -> name.equalsIgnoreCase(b.getText()))
            .findAny()
            .get();
    int[] before = paint();
    box.doClick();
    assertThat(paint()).isNotEqualTo(before);
    box.doClick();
    assertThat(paint()).isEqualTo(before);
  }

  @Test
  void paintsTheScene() {
    int width = panel.canvas().getWidth();
    int height = panel.canvas().getHeight();
    Color middle = new Color(paint()[height / 2 * width + width / 2]);
    assertThat(middle.getBlue()).as("the circle").isGreaterThan(middle.getRed() + 40);
  }

  @Test
  void dragsTheCircle() {
    SceneCanvas canvas = panel.canvas();
    Point middle = new Point(canvas.getWidth() / 2, canvas.getHeight() / 2);
    double scale = canvas.painter().transform(new Rectangle(canvas.getSize())).getScaleX();
    canvas.press(middle);
    canvas.drag(new Point(middle.x - 100, middle.y + 50));
    assertThat(player.scene().circle(0).x()).isCloseTo(50 - 100 / scale, offset(1e-9));
    assertThat(player.scene().circle(0).y()).isCloseTo(30 - 50 / scale, offset(1e-9));
  }

  @Test
  void savesWhatIsShownAndLoadsIt() throws Exception {
    button("Impact").doClick();
    button("Impact").doClick();
    player.seek(5);
    Path file = folder.resolve("now.csv");
    panel.save(file);
    Scene saved = Scene.read(file);
    assertThat(saved.circle(0).x()).isEqualTo(90);
    assertThat(saved.velocity(0).x()).isEqualTo(-8);
    assertThat(saved.restitution(ObstacleKind.LINE, 0)).isEqualTo(0.5);
    panel.load(file);
    assertThat(player.scene()).isEqualTo(saved);
    assertThat(panel.status()).endsWith("loaded " + file);
  }

  @Test
  void tellsWhatIsWrongWithAFile() throws Exception {
    Path file = folder.resolve("bad.csv");
    Files.writeString(file, "circle,1,2,x,0,0\n");
    panel.load(file);
    assertThat(panel.status()).contains("bad.csv:1:12: radius is \"x\"");
    assertThat(player.scene()).isEqualTo(SCENE);
    panel.save(folder.resolve("no/such/folder.csv"));
    assertThat(panel.status()).contains("folder.csv");
  }

  @Test
  void saysThatNothingIsAhead() {
    player.load(Scene.builder().circle(0, 0, 1, 0, 0).build());
    button("Impact").doClick();
    assertThat(panel.status()).endsWith("no impact ahead");
  }
}
