// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.Expansion;
import dev.carom.internal.exact.GapPolynomial;
import dev.carom.oracle.Roots;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The quartics on which pooltool tests its solver (github.com/ekiefl/pooltool, Apache License 2.0):
 * 1,000 with roots of very different size, close together or nearly multiple, and 1,000 of those
 * with which A. G. Orellana and C. De Michele tested ACM's Algorithm 1010. Mirrored and negated,
 * too, so that each root is one at which a gap falls.
 */
class QuarticsTest {
  private static final int LENGTH = 5;
  private static final int VARIANTS = 4;

  /** Beyond each root: 1 and the greatest quotient with the last coefficient (Cauchy's bound). */
  private static double reach(double[] c) {
    double greatest = Arrays.stream(c).map(Math::abs).max().orElseThrow();
    return 2 + 2 * greatest / Math.abs(c[LENGTH - 1]);
  }

  private static double[][] read(String name) throws IOException {
    try (InputStream in = QuarticsTest.class.getResourceAsStream("/quartics/" + name + ".npy")) {
      ByteBuffer bytes = ByteBuffer.wrap(in.readAllBytes()).order(ByteOrder.LITTLE_ENDIAN);
      bytes.position(10 + bytes.getShort(8)); // after magic bytes, version, and the header
      double[][] quartics = new double[bytes.remaining() / (LENGTH * Double.BYTES)][LENGTH];
      for (double[] c : quartics) {
        Arrays.setAll(c, i -> bytes.getDouble());
      }
      return quartics;
    }
  }

  private static double[] variant(double[] c, int sign, int mirror) {
    double[] other = new double[LENGTH];
    Arrays.setAll(other, i -> sign * (i % 2 == 0 ? 1 : mirror) * c[i]);
    return other;
  }

  /** Each time at which the search sees the polynomial fall from above 0; NaN where it gives up. */
  private static double[] falls(double[] c) {
    Expansion[] exact =
        Arrays.stream(c).mapToObj(x -> Expansion.sum(x, 0)).toArray(Expansion[]::new);
    double[] found = new double[LENGTH];
    int n = 0;
    double t = -1;
    while (t < GapSearch.NEVER) {
      t =
          new GapSearch(GapPolynomial.exact(exact))
              .time(GapSearch.ENTRY, t, reach(c), GapSearch.NEVER);
      found[n++] = t;
    }
    return Arrays.copyOf(found, Double.isNaN(t) ? n : n - 1);
  }

  /**
   * What the search leaves open goes to exact numbers. In the hard set these are clusters of four
   * roots, and roots that are further apart than the search halves.
   */
  @ParameterizedTest
  @CsvSource({"hard, 2879, 988", "algorithm1010, 1574, 0"})
  void noRootIsWrongAndFewQuarticsStayOpen(String set, int leastFound, int mostOpen)
      throws IOException {
    int found = 0;
    int open = 0;
    for (double[] quartic : read(set)) {
      for (int k = 0; k < VARIANTS; k++) {
        double[] c = variant(quartic, k < 2 ? 1 : -1, k % 2 == 0 ? 1 : -1);
        double[] expected = Roots.falls(c);
        double[] falls = falls(c);
        boolean isOpen = falls.length > 0 && Double.isNaN(falls[falls.length - 1]);
        int sure = falls.length - (isOpen ? 1 : 0);
        assertThat(Arrays.copyOf(falls, sure))
            .as(Arrays.toString(c))
            .isEqualTo(isOpen ? Arrays.copyOf(expected, sure) : expected);
        found += sure;
        open += isOpen ? 1 : 0;
      }
    }
    assertThat(found).isGreaterThanOrEqualTo(leastFound);
    assertThat(open).isLessThanOrEqualTo(mostOpen);
  }
}
