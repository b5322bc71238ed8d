// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.measures.Parts;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/** The scenes of the comparison, in a few words each. */
final class Scenes {

  private static final Map<String, List<String>> WORDS = Texts.table("scenes.txt");

  private Scenes() {}

  /** Those that are described, in the order of the report. */
  static Set<String> all() {
    return WORDS.keySet();
  }

  /** Describes a scene; empty for an unknown one. */
  static String what(String scene) {
    return WORDS.getOrDefault(scene, List.of("")).get(0);
  }

  /** What it stands for, for a title. */
  static String words(String scene) {
    String what = what(scene);
    return what.isEmpty()
        ? scene
        : what.substring(0, 1).toUpperCase(Locale.ROOT) + what.substring(1);
  }

  /** How many circles and lines it has, to stand behind a frame; nothing for one not known. */
  static String size(String name) {
    if (what(name).isEmpty()) {
      return "";
    }
    Scene scene = Parts.scene(name);
    String circles = " of " + scene.count(Kind.CIRCLE) + " circles";
    return scene.count(Kind.LINE) == 0
        ? circles
        : circles + " among " + scene.count(Kind.LINE) + " lines";
  }

  /** The cells of a table: circles, lines, size, radius, speed. */
  static List<String> facts(String name) {
    Scene scene = Parts.scene(name);
    int n = scene.count(Kind.CIRCLE);
    return List.of(
        Integer.toString(n),
        Integer.toString(scene.count(Kind.LINE)),
        scene
            .bounds()
            .map(b -> number(b.xmax() - b.xmin()) + " x " + number(b.ymax() - b.ymin()))
            .orElse("none"),
        range(n, i -> ((Circle) scene.shape(Kind.CIRCLE, i)).radius()),
        range(n, i -> scene.velocity(Kind.CIRCLE, i).length()));
  }

  private static String range(int n, IntToDoubleFunction value) {
    double least = IntStream.range(0, n).mapToDouble(value).min().orElse(0);
    double most = IntStream.range(0, n).mapToDouble(value).max().orElse(0);
    String from = number(least);
    String to = number(most);
    return from.equals(to) ? from : from + " to " + to;
  }

  private static String number(double value) {
    return ReportNumbers.ratio(Math.round(100 * value) / 100.0);
  }
}
