// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The scenes of the comparison, in a few words each. */
final class Scenes {

  /** By scene, in the order of the report: what it stands for, what it has, and its numbers. */
  private static final Map<String, List<String>> WORDS = Texts.table("scenes.txt");

  private Scenes() {}

  static Map<String, List<String>> all() {
    return WORDS;
  }

  /** What it stands for, for a title. */
  static String title(String scene) {
    String words = WORDS.getOrDefault(scene, List.of(scene)).get(0);
    return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
  }

  /** How many circles and lines it has, to stand behind a frame; nothing for one not known. */
  static String size(String scene) {
    return WORDS.containsKey(scene) ? " of " + WORDS.get(scene).get(1) : "";
  }
}
