// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

/**
 * The outcome of a run, judged at the end of every frame: the last of these that applies. The
 * thresholds are the same for all methods.
 */
public enum CellOutcome {
  RIGHT("right", "never more than 0.001 radius from the true place"),
  DRIFTED("drifted", "up to 1 radius away"),
  FAR_OFF("far off", "more than 1 radius away"),
  LOST_SPEED("lost speed", "speed at the end wrong by over 1 % of that at the start"),
  ESCAPED("escaped", "through a line, or at no finite place"),
  NO_ANSWER("no answer", "refuses the scene, or comes to no end");

  private final String label;
  private final String meaning;

  CellOutcome(String label, String meaning) {
    this.label = label;
    this.meaning = meaning;
  }

  /** Its name in texts: one or two words. */
  public String label() {
    return label;
  }

  /** When a run is of this class, unless one that comes later applies: a phrase. */
  public String meaning() {
    return meaning;
  }
}
