// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Where Carom is not the best in speed or accuracy, by rule from the data. */
final class Shortcomings {

  private Shortcomings() {}

  /** A sentence for each scene and each way to be as good or better. */
  static List<String> of(Results results) {
    return Stream.of(
            told(results, "Faster than Carom, though less accurate,", Standing::isFasterThan),
            told(results, "More accurate than Carom", Standing::isMoreAccurateThan),
            told(results, "As accurate as Carom", (s, ours) -> s.error() == ours.error()))
        .flatMap(sentences -> sentences)
        .toList();
  }

  private static Stream<String> told(
      Results results, String what, BiPredicate<Standing, Standing> who) {
    return results.scenes(Metrics.FRAME_ERROR).stream()
        .flatMap(
            scene -> {
              Standing ours = new Standing(results, scene, Metrics.CAROM);
              String names =
                  Standing.all(results, scene).stream()
                      .filter(s -> !s.isOurs() && who.test(s, ours))
                      .map(Standing::name)
                      .collect(Collectors.joining(", "));
              return names.isEmpty()
                  ? Stream.empty()
                  : Stream.of("%s in %s: %s.".formatted(what, scene, names));
            });
  }
}
