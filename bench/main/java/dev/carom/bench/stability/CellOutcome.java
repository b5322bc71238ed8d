// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

/**
 * The outcome of a run, judged at the end of every frame: the last of these that applies. The
 * thresholds are the same for all methods.
 */
public enum CellOutcome {
  /** Never more than 0.001 radius from its true place. */
  RIGHT("right", "never more than 0.001 radius from the true place"),

  /** Up to a radius away. */
  DRIFTED("drifted", "up to 1 radius away"),

  /** More than a radius away. */
  FAR_OFF("far off", "more than 1 radius away"),

  /** At the end the speed is wrong by more than a hundredth of that at the start. */
  LOST_SPEED("lost speed", "speed at the end wrong by over 1 % of that at the start"),

  /** Behind a line through which it cannot have come, or at no place that a number tells. */
  ESCAPED("escaped", "through a line, or at no finite place"),

  /** The method refuses the scene, or comes to no end. */
  NO_ANSWER("no answer", "refuses the scene, or comes to no end");

  private final String label;
  private final String meaning;

  CellOutcome(String label, String meaning) {
    this.label = label;
    this.meaning = meaning;
  }

  /**
   * Its name in texts.
   *
   * @return one or two words
   */
  public String label() {
    return label;
  }

  /**
   * When a run is of this class, unless one that comes later applies.
   *
   * @return a phrase
   */
  public String meaning() {
    return meaning;
  }
}
