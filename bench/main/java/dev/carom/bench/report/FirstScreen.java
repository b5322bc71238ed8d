// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** One sentence and three numbers for the first ten seconds, by rule from the data. */
final class FirstScreen {

  /**
   * One number, and what others reach.
   *
   * @param value with its unit
   * @param what what it counts
   */
  record Tile(String name, String value, String what, String rival) {}

  /** Errors up to so many times ours count as accurate as ours. */
  private static final double AS_ACCURATE = 10;

  private static final String ENGINE = "gdx-box2d";
  private static final String PUBLISHED = "poster";

  private final Results results;
  private final String scene;
  private final List<Standing> all;
  private final Optional<Standing> ours;

  FirstScreen(Results results) {
    this.results = results;
    scene = results.scenes(Metrics.FRAME_ERROR).stream().findFirst().orElse("");
    all = Standing.all(results, scene);
    ours = Standing.ours(all).filter(s -> !s.failed());
  }

  /** The scene that it is about; empty if nothing was measured. */
  String scene() {
    return scene;
  }

  /** One sentence. */
  String sentence() {
    if (ours.isEmpty()) {
      return "Not measured.";
    }
    Standing carom = ours.get();
    List<Standing> faster = all.stream().filter(s -> s.isFasterThan(carom)).toList();
    List<Standing> level =
        all.stream().filter(s -> !s.equals(carom) && s.isLevelWith(carom)).toList();
    String rank;
    if (!faster.isEmpty()) {
      rank = ", and not the fastest (" + names(faster) + ")";
    } else {
      rank = level.isEmpty() ? ", and the fastest measured" : ", and as fast as " + names(level);
    }
    List<String> rest = new ArrayList<>();
    nearest(carom).ifPresent(rest::add);
    engine(carom).ifPresent(rest::add);
    return "%s%s: the median frame%s takes %s%s."
        .formatted(
            exactness(),
            rank,
            Scenes.size(scene),
            ReportNumbers.time(carom.time().middle()),
            rest.isEmpty() ? "" : "; " + String.join("; ", rest));
  }

  private String exactness() {
    double wrong = sum(Metrics.MISSED) + sum(Metrics.INVENTED);
    double asked = sum(Metrics.DECISIONS);
    if (asked == 0) {
      return "Measured";
    }
    return wrong == 0 ? "Exact" : "Wrong in " + ReportNumbers.failures(wrong, asked) + " answers";
  }

  private double sum(String metric) {
    return results.scenes(metric).stream()
        .flatMap(s -> results.only(s, Metrics.CAROM, metric).stream())
        .mapToDouble(spread -> spread.middle())
        .sum();
  }

  private static String names(List<Standing> found) {
    return String.join(", ", found.stream().map(s -> Metrics.shortName(s.setting())).toList());
  }

  /** The fastest of all others that err at most ten times as much. */
  private Optional<String> nearest(Standing carom) {
    return all.stream()
        .filter(s -> !s.equals(carom) && !s.failed())
        .filter(s -> s.error() <= AS_ACCURATE * carom.error())
        .min(Comparator.comparingDouble(s -> s.time().middle()))
        .map(
            s ->
                "the nearest that is as accurate (%s%s) takes %s times as long"
                    .formatted(
                        Metrics.shortName(s.setting()),
                        Glossary.isControl(s.setting().method()) ? ", written for comparison" : "",
                        times(s, carom)));
  }

  private Optional<String> engine(Standing carom) {
    return best(ENGINE)
        .map(
            s ->
                "%s takes %s times as long and errs by up to %s radii"
                    .formatted(
                        Glossary.name(ENGINE), times(s, carom), ReportNumbers.error(s.error())));
  }

  /** The setting of a method that errs least. */
  private Optional<Standing> best(String method) {
    return all.stream()
        .filter(s -> s.setting().method().equals(method) && !s.failed())
        .min(Comparator.comparingDouble(Standing::error));
  }

  private static String times(Standing other, Standing carom) {
    double ratio = other.time().middle() / carom.time().middle();
    return ratio < 9.95
        ? ReportNumbers.ratio(Math.round(10 * ratio) / 10.0)
        : ReportNumbers.count(ratio);
  }

  /** Speed, accuracy and stability. */
  List<Tile> tiles() {
    List<Tile> tiles = new ArrayList<>();
    ours.ifPresent(
        carom -> {
          tiles.add(
              new Tile(
                  "Speed",
                  ReportNumbers.time(carom.time().middle()),
                  "a frame, median",
                  rivals(s -> ReportNumbers.time(s.time().middle()))));
          tiles.add(
              new Tile(
                  "Accuracy",
                  radii(carom),
                  "the worst error of one frame",
                  rivals(FirstScreen::radii)));
        });
    new StabilityMatrix(results).tile().ifPresent(tiles::add);
    return tiles;
  }

  private static String radii(Standing s) {
    return ReportNumbers.error(s.error()) + " radii";
  }

  private String rivals(Function<Standing, String> number) {
    List<String> texts = new ArrayList<>();
    for (String method : List.of(ENGINE, PUBLISHED)) {
      best(method).ifPresent(s -> texts.add(Glossary.name(method) + ": " + number.apply(s)));
    }
    return String.join("; ", texts);
  }
}
