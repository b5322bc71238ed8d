// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Polynomials made of known roots. */
class SturmPolynomialTest {

  /** The polynomial t - root. */
  private static SturmPolynomial factor(double root) {
    return new SturmPolynomial(Dyadic.of(-root), Dyadic.ONE);
  }

  /** Up to four factors; equal roots, and some that are neighbouring doubles, and some far off. */
  @Test
  void findsEachPositiveRootOnce() {
    Random random = new Random(1);
    for (int i = 0; i < 5_000; i++) {
      SturmPolynomial f = new SturmPolynomial(Dyadic.of(random.nextBoolean() ? 3 : -0.25));
      TreeSet<Double> roots = new TreeSet<>();
      double last = 1;
      for (int k = random.nextInt(5); k > 0; k--) {
        last =
            switch (random.nextInt(6)) {
              case 0 -> last;
              case 1 -> Math.nextUp(last);
              case 2 -> Math.scalb(1 + random.nextDouble(), random.nextInt(400) - 200);
              case 3 -> -random.nextInt(5);
              case 4 -> 0;
              default -> random.nextInt(1, 9) / 4.0;
            };
        f = f.times(factor(last));
        if (last > 0) {
          roots.add(last);
        }
      }
      if (random.nextInt(3) == 0) {
        f = f.times(new SturmPolynomial(Dyadic.of(1.25), Dyadic.of(-1), Dyadic.of(0.25)));
      }
      List<SturmRoot> found = f.positiveRoots();
      assertThat(found.stream().map(SturmRoot::nearest)).containsExactlyElementsOf(roots);
      for (SturmRoot root : found) {
        double t = root.nearest();
        assertThat(root.sign(factor(t))).isZero();
        assertThat(root.sign(factor(Math.nextUp(t)))).isNegative();
        assertThat(root.sign(factor(Math.nextDown(t)))).isPositive();
        assertThat(root.sign(f)).isZero();
      }
    }
  }
}
