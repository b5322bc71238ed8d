// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Rectangle2D;
import java.util.List;
import org.junit.jupiter.api.Test;

class DotLabelsTest {

  private static final Rectangle2D AREA = new Rectangle2D.Double(0, 0, 400, 300);

  private static DotLabels labels(double[]... dots) {
    DotLabels labels = new DotLabels(AREA);
    for (double[] dot : dots) {
      labels.avoid(dot[0], dot[1], 6);
      labels.add(dot[0], dot[1], "method 128");
    }
    return labels;
  }

  @Test
  void aTextStandsRightOfALoneDot() {
    Rectangle2D box = labels(new double[] {100, 100}).place().get(0).box();
    assertThat(box.getX()).isEqualTo(108);
    assertThat(box.getCenterY()).isCloseTo(100, within(1e-3));
  }

  @Test
  void aTextStaysInTheArea() {
    Rectangle2D box = labels(new double[] {399, 299}).place().get(0).box();
    assertThat(AREA.contains(box)).isTrue();
    assertThat(box.intersects(393, 293, 12, 12)).isFalse();
  }

  @Test
  void textsOfACrowdTouchNeitherEachOtherNorADot() {
    double[][] dots = new double[12][];
    for (int i = 0; i < dots.length; i++) {
      dots[i] = new double[] {150 + 7 * (i % 4), 120 + 13 * (i / 4)};
    }
    List<DotLabels.Placed> placed = labels(dots).place();
    assertThat(placed).hasSize(12);
    for (DotLabels.Placed one : placed) {
      for (DotLabels.Placed other : placed) {
        assertThat(one.equals(other) || !one.box().intersects(other.box())).isTrue();
      }
      for (double[] dot : dots) {
        assertThat(one.box().intersects(dot[0] - 6, dot[1] - 6, 12, 12)).isFalse();
      }
    }
  }

  @Test
  void noTextIsStruckThroughByTheLineOfAnother() {
    List<DotLabels.Placed> placed =
        labels(new double[] {390, 100}, new double[] {391, 101}, new double[] {392, 102}).place();
    for (DotLabels.Placed one : placed) {
      for (DotLabels.Placed other : placed) {
        DotLabels.Label dot = one.label();
        Rectangle2D end = one.box();
        boolean struck =
            !one.equals(other)
                && other.box().intersectsLine(dot.x(), dot.y(), end.getMaxX(), end.getCenterY());
        assertThat(struck).isFalse();
      }
    }
  }

  @Test
  void aTextKeepsOffALine() {
    DotLabels labels = labels(new double[] {100, 100}).avoid(100, 100, 400, 100);
    assertThat(labels.place().get(0).box().intersectsLine(100, 100, 400, 100)).isFalse();
  }
}
