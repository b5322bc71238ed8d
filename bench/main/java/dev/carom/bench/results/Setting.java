// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

/**
 * A method with its knob turned to a value: one dot of a chart.
 *
 * @param method the label of the method
 * @param knob its setting, {@code name=value}; empty if it has none
 */
public record Setting(String method, String knob) {

  /** The value of the knob: what stands after the equals sign, or all there is. */
  public String value() {
    return knob.substring(knob.indexOf('=') + 1);
  }

  @Override
  public String toString() {
    return knob.isEmpty() ? method : method + " (" + knob + ")";
  }
}
