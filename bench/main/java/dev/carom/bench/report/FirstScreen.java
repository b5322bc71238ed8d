// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** One sentence and three numbers for the first ten seconds, by rule from the data. */
final class FirstScreen {

  /**
   * One number, and what others reach.
   *
   * @param value with its unit
   * @param what what it counts
   */
  record Tile(String name, String value, String what, String rival) {}

  static final String PUBLISHED = "poster";
  static final String ENGINE = "gdx-box2d";

  /** Errors up to so many times ours count as accurate as ours. */
  private static final double AS_ACCURATE = 10;

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
    return ours.map(this::sentence).orElse("Not measured.");
  }

  private String sentence(Standing carom) {
    String parts =
        Stream.of(nearest(carom), engine(carom))
            .flatMap(Optional::stream)
            .map(part -> "; " + part)
            .collect(Collectors.joining());
    return "%s, %s: the median frame%s takes %s%s."
        .formatted(
            exactness(), rank(carom), Scenes.size(scene), ReportNumbers.time(time(carom)), parts);
  }

  private String exactness() {
    Answers answers = Answers.ours(results);
    if (!answers.asked()) {
      return "Measured";
    }
    return answers.wrong() == 0 ? "Exact" : "Wrong in " + answers.text() + " answers";
  }

  private String rank(Standing carom) {
    if (all.stream().anyMatch(s -> s.isFasterThan(carom))) {
      return "and not the fastest (" + Standing.faster(all, "median") + ")";
    }
    List<Standing> level = carom.others().filter(s -> s.isLevelWith(carom)).toList();
    String names = level.stream().map(Standing::name).collect(Collectors.joining(", "));
    boolean areControls = level.stream().allMatch(s -> Glossary.isControl(s.method()));
    return level.isEmpty()
        ? "and the fastest measured"
        : "and as fast as " + names + (areControls ? " (written for comparison)" : "");
  }

  /** The fastest of all others told apart in time that err at most ten times as much. */
  private Optional<String> nearest(Standing carom) {
    return all.stream()
        .filter(s -> !s.isOurs() && !s.failed() && !s.isLevelWith(carom))
        .filter(s -> s.error() <= AS_ACCURATE * carom.error())
        .min(Comparator.comparingDouble(FirstScreen::time))
        .map(
            s ->
                "the nearest that is as accurate (%s%s) takes %s times as long"
                    .formatted(
                        s.name(),
                        Glossary.isControl(s.method()) ? ", written for comparison" : "",
                        times(s, carom)));
  }

  private Optional<String> engine(Standing carom) {
    return best(ENGINE)
        .map(
            s ->
                "%s takes %s times as long and errs by up to %s"
                    .formatted(
                        Glossary.name(ENGINE), times(s, carom), ReportNumbers.radii(s.error())));
  }

  private static double time(Standing s) {
    return s.time().middle();
  }

  private static String times(Standing other, Standing carom) {
    return ReportNumbers.times(time(other) / time(carom));
  }

  /** The setting of a method that errs least. */
  private Optional<Standing> best(String method) {
    return all.stream()
        .filter(s -> s.method().equals(method) && !s.failed())
        .min(Comparator.comparingDouble(Standing::error));
  }

  /** Speed, accuracy and stability. */
  List<Tile> tiles() {
    List<Tile> tiles = new ArrayList<>();
    ours.ifPresent(
        carom -> {
          tiles.add(tile("Speed", carom, "a frame, median", s -> ReportNumbers.time(time(s))));
          tiles.add(
              tile(
                  "Accuracy",
                  carom,
                  "the worst error of one frame",
                  s -> ReportNumbers.radii(s.error())));
        });
    new StabilityMatrix(results).tile().ifPresent(tiles::add);
    return tiles;
  }

  private Tile tile(String name, Standing carom, String what, Function<Standing, String> number) {
    String rivals =
        Stream.of(ENGINE, PUBLISHED)
            .flatMap(method -> best(method).stream())
            .map(s -> Glossary.name(s.method()) + ": " + number.apply(s))
            .collect(Collectors.joining("; "));
    return new Tile(name, number.apply(carom), what, rivals);
  }
}
