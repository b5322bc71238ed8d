// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.World;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

class SceneDrawingTest {

  private static final Rectangle AREA = new Rectangle(0, 0, 140, 100);

  /** With a margin of 20 pixels, one unit is one pixel: (x, y) lies at (20 + x, 80 - y). */
  private static final Scene SCENE =
      Scene.builder()
          .bounds(0, 0, 100, 60)
          .line(10, 10, 30, 10)
          .peg(50, 10, 4)
          .circle(80, 45, 8, 0, -10)
          .build();

  private static BufferedImage draw(SceneDrawing drawing, Still still) {
    BufferedImage image = new BufferedImage(140, 120, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    g.setColor(Style.PAPER);
    g.fillRect(0, 0, 140, 120);
    drawing.draw(g, AREA, still);
    g.dispose();
    return image;
  }

  private static Color at(BufferedImage image, int x, int y) {
    return new Color(image.getRGB(20 + x, 80 - y));
  }

  @Test
  void whatIsSolidIsDarkAndWhereItIs() {
    BufferedImage image = draw(SceneDrawing.of(SCENE), Still.of(SCENE));
    assertThat(at(image, 20, 10)).isEqualTo(Style.INK);
    assertThat(at(image, 50, 10)).isEqualTo(Style.INK);
    assertThat(at(image, 52, 12)).isEqualTo(Style.INK);
    assertThat(at(image, 50, 16)).isEqualTo(Style.FLOOR);
    assertThat(at(image, 20, 14)).isEqualTo(Style.FLOOR);
    assertThat(at(image, 50, -1)).as("below the lower wall").isEqualTo(Style.INK);
    assertThat(at(image, 50, 1)).as("above it").isEqualTo(Style.FLOOR);
    assertThat(at(image, 50, -10)).as("margin").isEqualTo(Style.PAPER);
  }

  @Test
  void circlesAreBlueWithYUpwards() {
    BufferedImage image = draw(SceneDrawing.of(SCENE).withArrowTime(0), Still.of(new World(SCENE)));
    Color inside = at(image, 80, 45);
    assertThat(inside.getBlue()).isGreaterThan(inside.getRed() + 40);
    assertThat(at(image, 80, 15)).as("mirrored").isEqualTo(Style.FLOOR);
  }

  @Test
  void anArrowPointsWhereTheCircleGoes() {
    BufferedImage image = draw(SceneDrawing.of(SCENE).withArrowTime(2), Still.of(SCENE));
    assertThat(at(image, 80, 30)).as("on the way down").isNotEqualTo(Style.FLOOR);
    assertThat(at(image, 80, 22)).as("beyond the end").isEqualTo(Style.FLOOR);
    assertThat(at(image, 80, 56)).as("behind").isEqualTo(Style.FLOOR);
  }

  @Test
  void arrowsSuitTheSpeed() {
    // 4 % of the diagonal, 4.66, at 10 units a frame: 0.466 frames, rounded down.
    assertThat(SceneDrawing.of(SCENE).arrowTime()).isEqualTo(0.3);
    Scene still = Scene.builder().circle(0, 0, 1, 0, 0).build();
    assertThat(SceneDrawing.of(still).arrowTime()).isZero();
  }

  @Test
  void aCircleHasTheColourThatItWasGivenUnlessItGlows() {
    Still green = Still.of(SCENE).colored(i -> Style.GREEN);
    SceneDrawing drawing = SceneDrawing.of(SCENE).withArrowTime(0);
    assertThat(at(draw(drawing, green), 80, 48)).isEqualTo(Style.GREEN);
    Color glowing = at(draw(drawing, green.glowing(i -> true)), 80, 48);
    assertThat(glowing.getRed()).isGreaterThan(glowing.getGreen());
  }

  @Test
  void aDarkSchemeHasALightInkOnADarkFloor() {
    SceneDrawing dark = SceneDrawing.of(SCENE).withScheme(Style.Scheme.DARK);
    assertThat(at(draw(dark, Still.of(SCENE)), 80, 15)).isEqualTo(Style.Scheme.DARK.floor());
  }

  @Test
  void nothingIsDrawnOutsideTheArea() {
    Scene open =
        Scene.builder().collide(false).circle(0, 0, 1, 0, 0).circle(1, 0, 1, 0, -1000).build();
    World world = new World(open);
    world.step(1);
    BufferedImage image = draw(SceneDrawing.of(open).withArrowTime(1), Still.of(world));
    for (int x = 0; x < 140; x++) {
      assertThat(new Color(image.getRGB(x, 110))).isEqualTo(Style.PAPER);
    }
  }

  @Test
  void sizeKeepsProportionsAndTheMapCanBeInverted() throws Exception {
    SceneDrawing drawing = SceneDrawing.of(SCENE);
    assertThat(drawing.size(140, 1000)).isEqualTo(new Dimension(140, 100));
    assertThat(drawing.withMargin(0).size(1000, 60)).isEqualTo(new Dimension(100, 60));
    Point2D point = new Point2D.Double(30, 50);
    Point2D back = drawing.transform(AREA).inverseTransform(point, null);
    assertThat(back).isEqualTo(new Point2D.Double(10, 30));
    assertThat(drawing.place(AREA, new Vec2(30 / 140.0, 50 / 100.0))).isEqualTo(new Vec2(10, 30));
  }
}
