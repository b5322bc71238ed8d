// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.measures.RoundingPart;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Spread;
import java.util.Optional;

/** Explains the worst error of a frame with many impacts. */
final class RoundingNote {

  private final Results results;
  private final String scene;

  RoundingNote(Results results, String scene) {
    this.results = results;
    this.scene = scene;
  }

  private double stat(String name) {
    return results.value(scene, Metrics.CAROM, RoundingPart.METRIC, name);
  }

  /** How many of how many are above the limit, or nothing if that was not counted. */
  Optional<String> above() {
    Optional<Spread> above =
        results.spread(scene, Metrics.CAROM, RoundingPart.METRIC, RoundingPart.ABOVE);
    return above.map(
        spread ->
            "%s of %s circle-frames above"
                .formatted(
                    ReportNumbers.count(spread.middle()),
                    ReportNumbers.count((double) spread.n())));
  }

  /** Two sentences, or nothing if it was not measured. */
  Optional<String> sentences() {
    return above()
        .map(
            count ->
                "Errors of single frames of %s: %s %s x 2^-53 times their conditioning; the worst, of %s, has %s impacts. A place is a double by contract, the start of each flight: exact arithmetic that rounds nothing but the places of these impacts errs there by %s. By frame, the worst error of all circles against the greatest conditioning of all: at most %s."
                    .formatted(
                        scene,
                        count,
                        ReportNumbers.ratio(RoundingPart.LIMIT),
                        ReportNumbers.ratio(stat("max")),
                        ReportNumbers.count(stat(RoundingPart.IMPACTS)),
                        ReportNumbers.ratio(stat(RoundingPart.ROUNDED)),
                        ReportNumbers.ratio(stat(RoundingPart.OF_FRAMES))));
  }
}
