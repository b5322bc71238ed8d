// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import java.util.ArrayList;
import java.util.List;

/**
 * A detector that is compared with others, on single queries: when does a circle meet a line?
 *
 * @param id its name in options, unique
 * @param method the label of the method
 * @param knob the setting, {@code name=value}; empty if the method has none
 * @param detector gives the answers
 */
public record LineContender(String id, String method, String knob, LineDetector detector) {

  private static final int LEAST_TOLERANCE = -12;
  private static final int MOST_SAMPLES = 4096;

  /** All of them: in the order in which tables show them, this library first. */
  public static List<LineContender> all() {
    List<LineContender> all = new ArrayList<>();
    all.add(new LineContender("carom", "carom", "", new CaromDetector()));
    all.add(new LineContender("plain", "plain", "", new PlainDetector()));
    all.add(new LineContender("textbook-double", "textbook-double", "", new TextbookDetector()));
    all.add(
        new LineContender(
            "textbook-float",
            "textbook-float",
            "",
            new RoundedDetector(new FloatTextbookDetector())));
    all.add(new LineContender("poster", "poster", "", new PosterDetector()));
    for (int exponent = -2; exponent >= LEAST_TOLERANCE; exponent -= 2) {
      double tolerance = Double.parseDouble("1e" + exponent);
      String value = "1e" + exponent;
      all.add(
          new LineContender(
              "advancement-" + value,
              "advancement",
              "tolerance=" + value,
              new AdvancementDetector(tolerance)));
    }
    for (int samples = 16; samples <= MOST_SAMPLES; samples *= 16) {
      all.add(
          new LineContender(
              "closest-point-" + samples,
              "closest-point",
              "samples=" + samples,
              new ClosestPointDetector(samples)));
    }
    return List.copyOf(all);
  }

  /**
   * One of them.
   *
   * @throws IllegalArgumentException if there is none of this id
   */
  public static LineContender byId(String id) {
    return all().stream()
        .filter(contender -> contender.id().equals(id))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(id + " is no way to test a line"));
  }
}
