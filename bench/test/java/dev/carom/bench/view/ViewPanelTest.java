// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.view.ScenePainter.Layer;
import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.NoninvertibleTransformException;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Uses the panel without a screen: its buttons, its slider, the mouse, and what it paints. */
class ViewPanelTest {

  private static final Scene SCENE =
      Scene.builder()
          .collide(false)
          .bounds(0, 0, 100, 60)
          .line(20, 10, 60, 10)
          .restitution(0.5)
          .circle(50, 30, 10, 8, 0)
          .build();

  private final Player player = new Player(SCENE, 1);
  private final ViewPanel panel = new ViewPanel(player);

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

  private JSlider slider(String name) {
    return all(JSlider.class).stream().filter(s -> name.equals(s.getName())).findFirst().get();
  }

  private JButton button(String text) {
    return all(JButton.class).stream()
        .filter(b -> text.equals(b.getText()) || text.equals(b.getName()))
        .findFirst()
        .get();
  }

  /** The pixels of the canvas. */
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
    assertThat(panel.status()).isEqualTo("time 2.000, 0 impacts");
    button("Pause").doClick();
    panel.tick();
    assertThat(player.shown()).isEqualTo(2);
    button("Frame").doClick();
    assertThat(player.shown()).isEqualTo(3);
    button("Impact").doClick();
    assertThat(panel.status()).isEqualTo("time 5.000, 1 impact");
    button("Restart").doClick();
    assertThat(player.end()).isZero();
    slider("Speed").setValue(100);
    button("Run").doClick();
    panel.tick();
    assertThat(player.shown()).isEqualTo(10);
  }

  @Test
  void scrubs() {
    button("Impact").doClick();
    button("Impact").doClick();
    JSlider slider = slider("Time");
    assertThat(slider.getValue()).isEqualTo(slider.getMaximum());
    slider.setValue(slider.getMaximum() / 3);
    assertThat(panel.status()).startsWith("time 4.999 of 15.000 (past), 0 impacts");
    button("Impact").doClick();
    assertThat(panel.status()).isEqualTo("time 5.000 of 15.000 (past), 1 impact");
    assertThat(player.end()).isEqualTo(15);
  }

  @ParameterizedTest
  @EnumSource
  void showsEachLayer(Layer layer) {
    button("Impact").doClick();
    String name = layer.label();
    JCheckBox box =
        all(JCheckBox.class).stream().filter(b -> name.equals(b.getText())).findAny().get();
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
    canvas.drag(new Point(middle.x - 100, middle.y + 50), 0);
    assertThat(((Circle) player.scene().shape(Kind.CIRCLE, 0)).x())
        .isCloseTo(50 - 100 / scale, offset(1e-12));
    assertThat(((Circle) player.scene().shape(Kind.CIRCLE, 0)).y())
        .isCloseTo(30 - 50 / scale, offset(1e-12));
  }

  /** Three places far apart, all at one moment: a trail would be a line between them. */
  @Test
  void draggingLeavesNoTrail() {
    SceneCanvas canvas = panel.canvas();
    button("Frame").doClick();
    Point middle = new Point(canvas.getWidth() / 2 + 8, canvas.getHeight() / 2);
    canvas.press(middle);
    canvas.drag(new Point(middle.x, middle.y - 120), 0);
    canvas.drag(new Point(middle.x, middle.y + 120), 0);
    canvas.drag(middle, 0);
    int[] with = paint();
    JCheckBox trails =
        all(JCheckBox.class).stream().filter(b -> "Trails".equals(b.getText())).findAny().get();
    trails.doClick();
    assertThat(paint()).isEqualTo(with);
  }

  @Test
  void zoomsAroundTheMouseAndPans() {
    SceneCanvas canvas = panel.canvas();
    Rectangle area = new Rectangle(canvas.getSize());
    Point at = new Point(200, 150);
    Point2D before = inverse(canvas.painter().transform(area), at);
    double scale = canvas.painter().transform(area).getScaleX();
    canvas.zoom(3, at);
    assertThat(canvas.painter().transform(area).getScaleX()).isCloseTo(3 * scale, offset(1e-12));
    assertThat(inverse(canvas.painter().transform(area), at).distance(before)).isLessThan(1e-9);
    canvas.press(at);
    canvas.drag(new Point(230, 110), 0);
    canvas.release(0);
    Point2D after = inverse(canvas.painter().transform(area), new Point(230, 110));
    assertThat(after.distance(before)).isLessThan(1e-9);
    button("Fit").doClick();
    assertThat(canvas.painter().transform(area).getScaleX()).isEqualTo(scale);
  }

  private static Point2D inverse(AffineTransform map, Point at) {
    try {
      return map.inverseTransform(new Point2D.Double(at.x, at.y), null);
    } catch (NoninvertibleTransformException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void tellsWhatIsUnderTheMouse() {
    SceneCanvas canvas = panel.canvas();
    canvas.hover(new Point(canvas.getWidth() / 2, canvas.getHeight() / 2));
    assertThat(canvas.hovered())
        .containsExactly("circle 0 at 50.0000, 30.0000", "speed 8.000", "radius 10.00");
    canvas.hover(new Point(1, 1));
    assertThat(canvas.hovered()).isEmpty();
    canvas.hover(null);
    assertThat(canvas.hovered()).isEmpty();
  }

  @Test
  void addsWithEachToolAndDeletes() {
    SceneCanvas canvas = panel.canvas();
    Point from = new Point(canvas.getWidth() / 2, canvas.getHeight() / 2 - 200);
    for (Tool tool : List.of(Tool.CIRCLE, Tool.LINE, Tool.PEG)) {
      toggle(tool).doClick();
      canvas.press(from);
      canvas.drag(new Point(from.x + 40, from.y), 0);
      int[] drawn = paint();
      canvas.drag(new Point(from.x + 60, from.y + 30), 0);
      assertThat(paint()).as("%s is shown before it is added", tool).isNotEqualTo(drawn);
      canvas.release(0);
    }
    assertThat(player.scene())
        .extracting(s -> s.count(Kind.CIRCLE), s -> s.count(Kind.LINE), s -> s.count(Kind.PEG))
        .containsExactly(2, 2, 1);
    toggle(Tool.DELETE).doClick();
    canvas.press(from);
    canvas.press(from);
    canvas.press(from);
    assertThat(player.scene())
        .extracting(s -> s.count(Kind.CIRCLE), s -> s.count(Kind.LINE), s -> s.count(Kind.PEG))
        .containsExactly(1, 1, 0);
  }

  private JToggleButton toggle(Tool tool) {
    return all(JToggleButton.class).stream()
        .filter(b -> tool.name().equals(b.getName()))
        .findFirst()
        .get();
  }

  @Test
  void theSliderOfGravityShowsAndSetsIt() {
    JSlider gravity = slider("Gravity");
    gravity.setValue(50);
    double half = -player.scene().gravity().y();
    gravity.setValue(100);
    assertThat(-player.scene().gravity().y()).isCloseTo(2 * half, offset(1e-12)).isPositive();
    player.setGravity(0, -half);
    panel.told("");
    assertThat(gravity.getValue()).isEqualTo(50);
    assertThat(-player.scene().gravity().y()).isEqualTo(half);
  }

  @Test
  void theSpeedGoesFromAThousandthToAThousand() {
    JSlider speed = slider("Speed");
    speed.setValue(speed.getMinimum());
    button("Run").doClick();
    panel.tick();
    assertThat(player.shown()).isEqualTo(0.001);
    speed.setValue(speed.getMaximum());
    panel.tick();
    assertThat(player.shown()).isEqualTo(1000.001);
  }

  @Test
  void eachKeyHasAHintAndStandsInTheHelp() {
    String help = HelpPage.html(panel.keys());
    assertThat(panel.keys())
        .hasSizeGreaterThan(20)
        .allSatisfy(
            key -> assertThat(help).contains("<b>" + key.label() + "</b></td><td>" + key.tip()));
    assertThat(panel.keys()).extracting(KeyAction::label).doesNotHaveDuplicates();
    assertThat(all(AbstractButton.class))
        .allSatisfy(button -> assertThat(button.getToolTipText()).matches(".+ \\(.+\\)"));
  }

  @Test
  void theToolBarWraps() {
    JComponent bar = (JComponent) panel.getComponent(0);
    int row = bar.getPreferredSize().height;
    bar.setSize(300, row);
    assertThat(bar.getPreferredSize().height).isGreaterThan(3 * row);
    assertThat(bar.getPreferredSize().width).isLessThanOrEqualTo(300);
    bar.setSize(300, bar.getPreferredSize().height);
    bar.doLayout();
    assertThat(bar.getComponents())
        .allSatisfy(c -> assertThat(new Rectangle(bar.getSize()).contains(c.getBounds())).isTrue());
  }

  @Test
  void aKeyChangesGravity() {
    KeyAction weight =
        panel.keys().stream().filter(key -> "W".equals(key.label())).findFirst().orElseThrow();
    List<Double> down = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      weight.action().run();
      down.add(Math.abs(player.scene().gravity().y()));
    }
    assertThat(down.get(1)).isCloseTo(6 * down.get(0), offset(1e-12)).isBetween(1e-3, 1.0);
    assertThat(down.get(2)).isZero();
  }

  /** The trail of a circle that falls is bent: its middle lies above the chord. */
  @Test
  void trailsAndDraftsAreBent() {
    int[] rest = paint();
    player.setGravity(0, -0.05);
    SceneCanvas canvas = panel.canvas();
    toggle(Tool.CIRCLE).doClick();
    canvas.press(new Point(200, 200));
    canvas.drag(new Point(400, 200), 0);
    int[] bent = paint();
    player.setGravity(0, 0);
    assertThat(paint()).isNotEqualTo(bent).isNotEqualTo(rest);
  }

  @Test
  void darkIsDark() {
    Color light = new Color(paint()[0]);
    panel.setDark(true);
    assertThat(new Color(paint()[0]).getGreen()).isLessThan(light.getGreen() - 150);
  }

  @Test
  void saysThatNothingIsAhead() {
    player.load(Scene.builder().circle(0, 0, 1, 0, 0).build());
    button("Impact").doClick();
    assertThat(panel.status()).endsWith("no impact ahead");
  }
}
