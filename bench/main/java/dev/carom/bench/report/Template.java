// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import java.util.List;
import java.util.function.BiFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Texts with slots: {@code {{name}}}, or {@code {{name words}}}. */
final class Template {

  private static final Pattern SLOT = Pattern.compile("\\{\\{([a-z-]+) ?([a-z -]*)}}");

  private Template() {}

  /**
   * Fills a text that is kept beside the classes.
   *
   * @param slots what stands in a slot, by its name and its words
   */
  static String fill(String text, BiFunction<String, String, String> slots) {
    return SLOT.matcher(Texts.read(text))
        .replaceAll(slot -> Matcher.quoteReplacement(slots.apply(slot.group(1), slot.group(2))));
  }

  /** The figures of these ids, in this order; an id that ends with a hyphen stands for many. */
  static Stream<Figure> named(String ids, List<Figure> figures) {
    return Stream.of(ids.split(" "))
        .flatMap(
            id ->
                figures.stream()
                    .filter(
                        figure ->
                            figure.id().equals(id)
                                || (id.endsWith("-") && figure.id().startsWith(id))));
  }
}
