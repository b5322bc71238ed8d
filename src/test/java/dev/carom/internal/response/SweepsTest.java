// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Random contacts: the velocities nearest to those before with which no contact approaches. */
class SweepsTest {

  private static final int FIRST = 0;
  private static final int SECOND = 1;
  private static final int NX = 2;
  private static final int NY = 3;

  /** In units of the speeds: contacts whose normals are nearly opposite converge slowly. */
  private static final double SLACK = 1e-7;

  private final Random random = new Random(1);

  /**
   * The answer is the one of Moreau if no contact approaches, impulses are 0 or push, push only at
   * contacts that do not part, and make up all change of velocities. It is unique, so this needs no
   * second solver.
   *
   * @param spread masses are between 1 and this
   */
  @ParameterizedTest
  @CsvSource({"6, 10", "30, 2", "30, 100"})
  void nothingApproachesAndOnlyContactsThatTouchPush(int most, double spread) {
    for (int run = 0; run < 200; run++) {
      int count = 2 + random.nextInt(most);
      double[] weights = IntStream.range(0, count).mapToDouble(i -> weight(spread)).toArray();
      double[] before = random.doubles(2L * count, -1, 1).toArray();
      double[][] contacts = contacts(count, count);
      double[] after = new double[2 * count];
      Sweeps sweeps = solve(contacts, weights, before, after);
      double[] pushed = before.clone();
      for (int c = 0; c < contacts.length; c++) {
        double l = sweeps.impulse(c);
        double opening = opening(contacts[c], after);
        assertThat(l).as("run %s", run).isNotNegative();
        assertThat(opening).as("run %s", run).isGreaterThan(-SLACK);
        assertThat(l > 0 && opening > SLACK).as("run %s: pushes what parts", run).isFalse();
        push(contacts[c], l, weights, pushed);
      }
      for (int k = 0; k < after.length; k++) {
        assertThat(after[k]).as("run %s", run).isCloseTo(pushed[k], within(1e-10));
      }
    }
  }

  private double weight(double spread) {
    return 1 / (1 + (spread - 1) * random.nextDouble());
  }

  private double[][] contacts(int bodies, int count) {
    double[][] contacts = new double[count][];
    for (int c = 0; c < count; c++) {
      int a = random.nextInt(bodies);
      int b = (a + 1 + random.nextInt(bodies - 1)) % bodies;
      double angle = random.nextDouble() * 2 * Math.PI;
      contacts[c] = new double[] {a, b, Math.cos(angle), Math.sin(angle)};
    }
    return contacts;
  }

  private static Sweeps solve(
      double[][] contacts, double[] weights, double[] before, double[] after) {
    Sweeps sweeps = new Sweeps();
    sweeps.clear(contacts.length);
    for (double[] c : contacts) {
      int a = (int) c[FIRST];
      int b = (int) c[SECOND];
      sweeps.add(a, b, c[NX], c[NY], 0, weights[a], weights[b], 0);
    }
    int[] order = IntStream.range(0, weights.length).toArray();
    sweeps.load(order, order.length, before);
    sweeps.solve(ContactLaw.ROUNDED / 4, ContactLaw.MOST_SWEEPS);
    sweeps.store(order, after);
    return sweeps;
  }

  private static double opening(double[] contact, double[] v) {
    int a = 2 * (int) contact[FIRST];
    int b = 2 * (int) contact[SECOND];
    return (v[a] - v[b]) * contact[NX] + (v[a + 1] - v[b + 1]) * contact[NY];
  }

  private static void push(double[] contact, double l, double[] weights, double[] v) {
    int a = (int) contact[FIRST];
    int b = (int) contact[SECOND];
    v[2 * a] += l * weights[a] * contact[NX];
    v[2 * a + 1] += l * weights[a] * contact[NY];
    v[2 * b] -= l * weights[b] * contact[NX];
    v[2 * b + 1] -= l * weights[b] * contact[NY];
  }
}
