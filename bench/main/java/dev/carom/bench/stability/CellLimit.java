// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

/** Why no method in doubles, or no method at all, can be asked to be right in a cell. */
public enum CellLimit {
  /** Nothing is in the way. */
  NONE(""),

  /**
   * Four roundings of the start's doubles, multiplied by the conditioning of the true course, are
   * more than what counts as right: that is the accuracy that the library states.
   */
  DOUBLES("rounding of doubles, multiplied by the course, exceeds 0.001 radius"),

  /** Impacts without end in finite time. */
  PILE_UP("impacts without end pile up in finite time");

  private final String meaning;

  CellLimit(String meaning) {
    this.meaning = meaning;
  }

  /** The limit in words: a clause; empty for nothing. */
  public String meaning() {
    return meaning;
  }
}
