// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.state.BoundingBox;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class SizeClassesTest {

  /** A cell is so much wider than a diameter. */
  private static final double SLACK = 1 + 0x1p-20;

  private static SizeClasses classes(BoundingBox extent, double... radii) {
    SceneBuilder builder = Scene.builder().collide(false);
    for (double radius : radii) {
      builder.circle(0, 0, radius, 0, 0);
    }
    Scene scene = builder.build();
    CircleTable circles = new CircleTable(scene.count(Kind.CIRCLE));
    for (int i = 0; i < circles.count; i++) {
      circles.start(Internals.data(scene), i);
      circles.storeAndSetDue(i);
    }
    return new SizeClasses(
        circles, new CircleRegistry(Internals.data(scene), 1).slots(), extent, 1);
  }

  private static BoundingBox square(double side) {
    return new BoundingBox(0, 0, side, side);
  }

  @Test
  void cellsAreWiderThanADiameterAndMoreSoFarAway() {
    SizeClasses far = classes(new BoundingBox(0x1p40 - 10, 0, 0x1p40, 10), 1, 1, 1, 1);
    assertThat(far.slack()).isEqualTo(0x1p-8);
    assertThat(far.widths).containsExactly(2 * SLACK + 0x1p-8);
    assertThat(far.radii).containsExactly(1);
  }

  /** 4 circles, half the side apart: sparse if that is above 3 diameters. */
  @Test
  void cellsOfSparseCirclesAreAsWideAsTheirDistance() {
    double three = 6 * SLACK;
    assertThat(classes(square(100), 1, 1, 1, 1).widths).containsExactly(50 + 0x1p-48 * 100);
    assertThat(classes(square(2 * three), 1, 1, 1, 1).widths)
        .containsExactly(2 * SLACK + 0x1p-48 * 2 * three);
    assertThat(classes(square(2 * Math.nextUp(three)), 1, 1, 1, 1).widths[0]).isGreaterThan(three);
  }

  /** Also in a row, which has no area. */
  @Test
  void cellsOfCirclesInARowAreAsWideAsTheirDistance() {
    BoundingBox row = new BoundingBox(0, 3, 1e9, 3);
    assertThat(classes(row, 1, 1).widths).containsExactly(5e8 + 0x1p-48 * 1e9);
    assertThat(classes(row, 0, 0).widths).containsExactly(5e8 + 0x1p-48 * 1e9);
    assertThat(classes(new BoundingBox(3, 0, 3, 12), 1, 1).widths)
        .containsExactly(2 * SLACK + 0x1p-48 * 12);
    assertThat(classes(new BoundingBox(3, 3, 3, 3), 0, 0).widths).containsExactly(1);
  }

  /** In a square of 20 a crowd is 2 x 20^2 / 16^2 = 3.1 circles, those of radius 8 included. */
  @Test
  void classesAreSharedAsLongAsCirclesDoNotCrowdTheCells() {
    SizeClasses shared = classes(square(20), 8, 8, 4);
    assertThat(shared.radii).containsExactly(8);
    assertThat(shared.of(4)).isZero();
    assertThat(shared.of(8)).isZero();
    SizeClasses apart = classes(square(20), 8, 8, 8, 4);
    assertThat(apart.radii).containsExactly(4, 8);
    assertThat(apart.of(4)).isZero();
    assertThat(apart.of(8)).isOne();
    assertThat(apart.of(2)).isEqualTo(-1);
  }

  /** The area is such that a crowd is 4 circles, exactly. */
  @Test
  void fullIsNotCrowdedYet() {
    double width = 16 * SLACK + 0x1p-38;
    BoundingBox extent = new BoundingBox(-1024, 0, -1024 + 2 * width, width);
    assertThat(2 * extent.area() / (width * width)).isEqualTo(4);
    assertThat(classes(extent, 8, 8, 8, 4).radii).containsExactly(8);
    assertThat(classes(extent, 8, 8, 8, 4, 4).radii).containsExactly(4, 8);
  }

  /**
   * The spacing is that of all 16 circles, 5 apart in a square of 20, not that of the large one
   * alone.
   */
  @Test
  void theDistanceIsThatOfAllThatACellLists() {
    double[] radii = new double[16];
    Arrays.fill(radii, 0.5);
    radii[15] = 1;
    assertThat(classes(square(28), radii).widths).containsExactly(7 + 0x1p-48 * 28);
  }
}
