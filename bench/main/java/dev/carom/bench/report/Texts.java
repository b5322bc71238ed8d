// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Texts that are kept beside the classes. */
final class Texts {

  private static final Pattern SLOT = Pattern.compile("\\{\\{([a-z-]+) ?([a-z -]*)}}");
  private static final Pattern BAR = Pattern.compile(" \\| ");

  private Texts() {}

  static String read(String name) {
    try (InputStream in = Texts.class.getResourceAsStream(name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(name + " cannot be read", e);
    }
  }

  /**
   * Fills the slots of a text: {@code {{name}}}, or {@code {{name words}}}.
   *
   * @param slots what stands in a slot, by its name and its words
   */
  static String fill(String name, BiFunction<String, String, String> slots) {
    return SLOT.matcher(read(name))
        .replaceAll(slot -> Matcher.quoteReplacement(slots.apply(slot.group(1), slot.group(2))));
  }

  /** What stands behind the first word of each line, in parts, by that word. */
  static Map<String, List<String>> table(String name) {
    Map<String, List<String>> table = new LinkedHashMap<>();
    read(name)
        .lines()
        .map(line -> List.of(BAR.split(line)))
        .forEach(cells -> table.put(cells.get(0), cells.subList(1, cells.size())));
    return table;
  }
}
