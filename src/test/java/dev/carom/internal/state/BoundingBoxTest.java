// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import org.junit.jupiter.api.Test;

class BoundingBoxTest {

  private static BoundingBox of(Scene scene, CircleRegistry registry, double now) {
    CircleTable circles = new CircleTable(scene.count(Kind.CIRCLE));
    for (int i = 0; i < circles.count; i++) {
      circles.start(Internals.data(scene), i);
      circles.storeAndSetDue(i);
    }
    return BoundingBox.of(circles, registry.ids(), Internals.data(scene).obstacles.walls, now);
  }

  private static BoundingBox of(Scene scene, double now) {
    return of(scene, new CircleRegistry(Internals.data(scene), 1), now);
  }

  @Test
  void boundsAreTheExtent() {
    Scene scene = Scene.builder().bounds(1, 2, 5, 9).circle(3, 4, 1, 0, 0).build();
    assertThat(of(scene, 0)).isEqualTo(new BoundingBox(1, 2, 5, 9));
  }

  /** Half of the circles make the bounds the extent, on each axis; their edges belong to them. */
  @Test
  void boundsThatFewCirclesAreBetweenAreNotTheExtent() {
    SceneBuilder setup = Scene.builder().collide(false).bounds(1, 2, 5, 9);
    setup.circle(1, 2, 1, 0, 0).circle(5, 9, 1, 0, 0).circle(0, 1, 1, 0, 0);
    assertThat(of(setup.circle(6, 10, 1, 0, 0).build(), 0)).isEqualTo(new BoundingBox(1, 2, 5, 9));
    setup.circle(3, 11, 1, 0, 0).circle(5, 12, 1, 0, 0).circle(4, 13, 1, 0, 0);
    assertThat(of(setup.build(), 0)).isEqualTo(new BoundingBox(1, 1, 5, 13));
    setup.circle(7, 5, 1, 0, 0).circle(8, 5, 1, 0, 0);
    assertThat(of(setup.build(), 0)).isEqualTo(new BoundingBox(0, 1, 8, 13));
  }

  /** Of eight circles two are below the first quartile and two above the third one. */
  @Test
  void whoIsFarFromMostIsLeftOut() {
    double[] places = {0, 1, 2, 3, 4, 5, 6, 7};
    assertThat(extent(places)).isEqualTo(new BoundingBox(0, 0, 7, 7));
    places[0] = -1e9;
    places[7] = 1e9;
    assertThat(extent(places)).isEqualTo(new BoundingBox(-1, -1, 8, 8));
    places[1] = -2;
    places[6] = 8.5;
    assertThat(extent(places)).isEqualTo(new BoundingBox(-1, -1, 8, 8));
    places[6] = 2e8;
    places[5] = 2e8;
    assertThat(extent(places).right()).as("three of eight are not a few").isGreaterThan(1e8 - 4);
  }

  private static BoundingBox extent(double[] places) {
    SceneBuilder setup = Scene.builder().collide(false);
    for (int i = 0; i < places.length; i++) {
      setup.circle(places[i], places[(i + 3) % places.length], 1e-3, 0, 0);
    }
    return of(setup.build(), 0);
  }

  @Test
  void itHasAWidthAHeightAndALongerSide() {
    BoundingBox extent = new BoundingBox(-1, 2, 4, 5);
    assertThat(extent.width()).isEqualTo(5);
    assertThat(extent.height()).isEqualTo(3);
    assertThat(extent.side()).isEqualTo(5);
    assertThat(new BoundingBox(-1, 2, 4, 9).side()).isEqualTo(7);
  }

  @Test
  void withoutBoundsTheCentresAreAsTheyAreNow() {
    Scene scene =
        Scene.builder().collide(false).circle(3, 4, 1, -1, 2).circle(-1, 7, 1, 0, 0).build();
    assertThat(of(scene, 0)).isEqualTo(new BoundingBox(-1, 4, 3, 7));
    assertThat(of(scene, 5)).isEqualTo(new BoundingBox(-2, 7, -1, 14));
  }

  @Test
  void oneCircleIsAPoint() {
    assertThat(of(Scene.builder().circle(3, 4, 1, 0, 0).build(), 0))
        .isEqualTo(new BoundingBox(3, 4, 3, 4));
    assertThat(of(Scene.builder().build(), 0)).isEqualTo(new BoundingBox(0, 0, 0, 0));
  }

  @Test
  void whatIsGoneOrWouldOverflowIsLeftOut() {
    SceneBuilder setup =
        Scene.builder().collide(false).circle(3, 4, 1, 0, 0).circle(0, 90, 1, 0, 0);
    Scene scene = setup.circle(9, 9, 1, 1e308, 1e308).circle(9, 9, 1, -1e150, 1e150).build();
    CircleRegistry registry = new CircleRegistry(Internals.data(scene), 1);
    registry.remove(1);
    assertThat(of(scene, registry, 10)).isEqualTo(new BoundingBox(3, 4, 3, 4));
    setup = Scene.builder().bounds(-1e308, 0, 2, 1e308).circle(1, 2, 1e300, 0, 0);
    BoundingBox extent = of(setup.build(), 0);
    assertThat(extent).isEqualTo(new BoundingBox(-0x1p500, 0, 2, 0x1p500));
    assertThat(extent.area()).isEqualTo(0x1p1000);
  }

  @Test
  void itHasAnAreaAndAFarthestCoordinate() {
    BoundingBox extent = new BoundingBox(-1, 2, 4, 5);
    assertThat(extent.area()).isEqualTo(15);
    assertThat(extent.farthest()).isEqualTo(5);
    assertThat(new BoundingBox(-8, 2, 4, 5).farthest()).isEqualTo(8);
    assertThat(new BoundingBox(-8, 2, 9, 5).farthest()).isEqualTo(9);
    assertThat(new BoundingBox(-8, -10, 9, 5).farthest()).isEqualTo(10);
  }
}
