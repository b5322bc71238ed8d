// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.measures.Part;
import java.util.List;
import java.util.regex.Pattern;

/** Which parts of a report are to be run. What they do can be told from their ids. */
final class PartChoice {

  private static final Pattern TIMED =
      Pattern.compile("(?:time|query-time|sweep|scale|features|worlds)/.*");

  private PartChoice() {}

  /** Those that take no times: what they find is the same on every machine, however busy. */
  static List<Part> untimed(List<Part> all) {
    return all.stream().filter(part -> !TIMED.matcher(part.id()).matches()).toList();
  }
}
