// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.measures.Part;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Which parts of a report are to be run. What they do can be told from their ids. */
final class PartChoice {

  private static final Pattern TIMED = Pattern.compile("(?:time|query-time|sweep|scale)/.*");
  private static final Pattern OF_SCENE = Pattern.compile("(?:scene|time)/([^/]+)/.*");

  private PartChoice() {}

  /** Those that take no times: what they find is the same on every machine, however busy. */
  static List<Part> untimed(List<Part> all) {
    return all.stream().filter(part -> !TIMED.matcher(part.id()).matches()).toList();
  }

  /**
   * Those that play one of these scenes, and those that play none.
   *
   * @throws IllegalArgumentException if there is no such scene; the message names all there are
   */
  static List<Part> ofScenes(List<Part> all, List<String> scenes) {
    Set<String> known = new TreeSet<>();
    all.forEach(part -> scene(part).ifPresent(known::add));
    for (String name : scenes) {
      if (!known.contains(name)) {
        throw new IllegalArgumentException(
            "--scenes has " + name + ": expected " + String.join(", ", known));
      }
    }
    return all.stream().filter(part -> scene(part).map(scenes::contains).orElse(true)).toList();
  }

  private static Optional<String> scene(Part part) {
    Matcher matcher = OF_SCENE.matcher(part.id());
    return matcher.matches() ? Optional.of(matcher.group(1)) : Optional.empty();
  }
}
