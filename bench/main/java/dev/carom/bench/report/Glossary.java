// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Setting;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** What methods and their settings are called where people read. */
final class Glossary {

  /**
   * By method: its name, short enough to stand at a dot, a sentence, and where it stands. Charts
   * leave out those that say what another one says: a chart of a dozen marks is not read.
   */
  private static final Map<String, List<String>> METHODS = Texts.table("methods.txt");

  /** The knob of a peer, which is left as it comes or set as well as its documentation allows. */
  private static final String PEER = "setting=";

  private Glossary() {}

  /** The methods, in an order in which they explain each other. */
  static Set<String> methods() {
    return METHODS.keySet();
  }

  private static List<String> words(String method) {
    return METHODS.getOrDefault(method, List.of(method, "", "charts"));
  }

  /** How a method is called; one that is not known keeps its label. */
  static String name(String method) {
    return words(method).get(0);
  }

  /** What a method is; empty for one that is not known. */
  static String what(String method) {
    return words(method).get(1);
  }

  /** Whether a method stands in charts, not only in tables. */
  static boolean isDrawn(String method) {
    return words(method).get(2).contains("charts");
  }

  /** Whether a method was only written to tell what a part of carom gives. */
  static boolean isControl(String method) {
    return what(method).contains("a control for");
  }

  /** A method in words and its whole setting. */
  static String fullName(Setting setting) {
    return new Setting(name(setting.method()), setting.knob()).toString();
  }

  /** A method in words and what stands at its dot. */
  static String shortName(Setting setting) {
    return (name(setting.method()) + " " + shortKnob(setting)).strip();
  }

  /** The label of a dot: the value of the knob, or a short name for the long setting of a peer. */
  static String shortKnob(Setting setting) {
    if (isDefault(setting)) {
      return "defaults";
    }
    return isEngine(setting) ? "tuned" : setting.value();
  }

  /** Whether it is a physics engine, which is compared as it comes and tuned. */
  static boolean isEngine(Setting setting) {
    return setting.knob().startsWith(PEER);
  }

  /** Whether a peer is left as it comes. */
  static boolean isDefault(Setting setting) {
    return setting.value().startsWith("default");
  }
}
