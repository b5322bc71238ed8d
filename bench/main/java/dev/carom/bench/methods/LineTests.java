// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import java.util.ArrayList;
import java.util.List;

/**
 * The ways to answer one question, circle against line, that are compared.
 *
 * @param id its name in options, unique
 * @param method the label of the method
 * @param knob the setting, {@code name=value}; empty if the method has none
 * @param test the answers
 */
public record LineTests(String id, String method, String knob, LineTest test) {

  private static final int LEAST_TOLERANCE = -12;
  private static final int MOST_SAMPLES = 4096;

  /**
   * All of them.
   *
   * @return in the order in which tables show them, this library first
   */
  public static List<LineTests> all() {
    List<LineTests> all = new ArrayList<>();
    all.add(new LineTests("carom", "carom", "", new CaromTest()));
    all.add(new LineTests("plain", "plain", "", new PlainTest()));
    all.add(new LineTests("textbook-double", "textbook-double", "", new TextbookTest()));
    all.add(new LineTests("textbook-float", "textbook-float", "", new TextbookFloatTest()));
    all.add(new LineTests("poster", "poster", "", new PublishedTest()));
    for (int exponent = -2; exponent >= LEAST_TOLERANCE; exponent -= 2) {
      double tolerance = Double.parseDouble("1e" + exponent);
      String value = "1e" + exponent;
      all.add(
          new LineTests(
              "advancement-" + value,
              "advancement",
              "tolerance=" + value,
              new AdvancementTest(tolerance)));
    }
    for (int samples = 16; samples <= MOST_SAMPLES; samples *= 16) {
      all.add(
          new LineTests(
              "closest-point-" + samples,
              "closest-point",
              "samples=" + samples,
              new ClosestPointTest(samples)));
    }
    return List.copyOf(all);
  }

  /**
   * One of them.
   *
   * @param id its id
   * @return the tests
   * @throws IllegalArgumentException if there is none of this id
   */
  public static LineTests byId(String id) {
    return all().stream()
        .filter(tests -> tests.id().equals(id))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(id + " is no way to test a line"));
  }
}
