// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.Expansion;
import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Polynomial;
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

  /** Quartics with a root that the search left open. */
  private int open;

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

  /** Each time at which the polynomial falls from above 0: by the search, or else exactly. */
  private double[] falls(double[] c) {
    Expansion[] sums =
        Arrays.stream(c).mapToObj(x -> Expansion.sum(x, 0)).toArray(Expansion[]::new);
    Dyadic[] numbers = Arrays.stream(c).mapToObj(Dyadic::of).toArray(Dyadic[]::new);
    ExactParabola exact = ExactParabola.ofGap(Polynomial.of(numbers));
    double[] found = new double[LENGTH];
    int n = 0;
    boolean isOpen = false;
    for (double t = -1; t < GapSearch.NEVER; n++) {
      double before = t;
      t =
          new GapSearch(GapPolynomial.exact(sums))
              .time(GapSearch.ENTRY, before, 0, reach(c), GapSearch.NEVER);
      if (Double.isNaN(t)) {
        isOpen = true;
        t = exact.timeAfter(before, GapSearch.NEVER);
      }
      found[n] = t;
    }
    open += isOpen ? 1 : 0;
    return Arrays.copyOf(found, n - 1);
  }

  /**
   * The search leaves some of the hard set to exact numbers: clusters of four roots, and roots that
   * are further apart than it halves.
   */
  @ParameterizedTest
  @CsvSource({"hard, 4000, 988", "algorithm1010, 4000, 0"})
  void noRootIsWrongAndFewAreLeftToExactNumbers(String set, int asked, int mostOpen)
      throws IOException {
    int quartics = 0;
    for (double[] quartic : read(set)) {
      for (int k = 0; k < VARIANTS; k++) {
        double[] c = variant(quartic, k < 2 ? 1 : -1, k % 2 == 0 ? 1 : -1);
        assertThat(falls(c)).as(Arrays.toString(c)).isEqualTo(Roots.falls(c));
        quartics++;
      }
    }
    assertThat(quartics).isEqualTo(asked);
    assertThat(open).isLessThanOrEqualTo(mostOpen);
    System.out.println(set + ": " + open + " of " + quartics + " left to exact numbers");
  }
}
