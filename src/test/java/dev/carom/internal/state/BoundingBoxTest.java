// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import org.junit.jupiter.api.Test;

class BoundingBoxTest {

  private static BoundingBox of(Scene scene, CircleRegistry registry, double now) {
    CircleTable circles = new CircleTable(scene.circleCount());
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

  @Test
  void withoutBoundsTheCentresAreAsTheyAreNow() {
    Scene scene = Scene.builder().circle(3, 4, 1, -1, 2).circle(-1, 7, 1, 0, 0).build();
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
  void whatIsGoneOrBeyondTheDoublesIsLeftOut() {
    SceneBuilder setup = Scene.builder().circle(3, 4, 1, 0, 0).circle(0, 90, 1, 0, 0);
    Scene scene = setup.circle(9, 9, 1, 0, 1e308).circle(9, 9, 1, 1e308, 0).build();
    CircleRegistry registry = new CircleRegistry(Internals.data(scene), 1);
    registry.remove(1);
    assertThat(of(scene, registry, 10)).isEqualTo(new BoundingBox(3, 4, 3, 4));
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
