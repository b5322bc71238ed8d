// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The cost of exact answers: of single questions by class, of frames by scene. */
final class PriceTables {

  private static final Setting PLAIN = new Setting("plain", "");
  private static final List<Setting> TESTS =
      List.of(PLAIN, new Setting("textbook-double", ""), new Setting("textbook-float", ""));
  private static final Setting GRID = new Setting("textbook-grid", "");
  private static final Setting PLAIN_GRID = new Setting("plain-grid", "");
  private static final Setting TEXTBOOK = new Setting("textbook-double", "");

  private final Results results;

  PriceTables(Results results) {
    this.results = results;
  }

  /** The classes of questions in which both were timed. */
  private List<String> classes() {
    return results.scenes(Metrics.QUERY_TIME).stream()
        .filter(scene -> !Double.isNaN(factor(scene, PLAIN)))
        .toList();
  }

  private double time(String scene, Setting setting) {
    return results
        .spread(scene, setting, Metrics.QUERY_TIME, "median")
        .or(() -> results.only(scene, setting, Metrics.QUERY_TIME))
        .map(Spread::middle)
        .orElse(Double.NaN);
  }

  private double factor(String scene, Setting setting) {
    return time(scene, Metrics.CAROM) / time(scene, setting);
  }

  private double wrong(String scene, Setting setting) {
    return Stream.of(Metrics.MISSED, Metrics.INVENTED)
        .mapToDouble(
            metric -> results.only(scene, setting, metric).map(Spread::middle).orElse(Double.NaN))
        .sum();
  }

  /** The factors, in one line. */
  String questionsTitle() {
    double[] factors =
        classes().stream().mapToDouble(scene -> factor(scene, PLAIN)).sorted().toArray();
    return factors.length == 0
        ? "What exact answers cost was not measured"
        : "An exact answer to a single question costs %s to %s times a plain test, by class of questions"
            .formatted(short2(factors[0]), short2(factors[factors.length - 1]));
  }

  private static String short2(double value) {
    return value < 9.95
        ? ReportNumbers.ratio(Math.round(10 * value) / 10.0)
        : ReportNumbers.count(value);
  }

  /** A row for each class. */
  ReportTable questions() {
    List<String> head = new ArrayList<>(List.of("class of questions", "Carom", "wrong"));
    TESTS.forEach(
        test -> {
          head.add(Glossary.name(test.method()));
          head.add("Carom takes");
          head.add("wrong");
        });
    ReportTable.Builder table = new ReportTable.Builder(head);
    for (String scene : classes()) {
      List<String> row = new ArrayList<>(List.of(Metrics.queryClass(scene)));
      row.add(ReportNumbers.time(time(scene, Metrics.CAROM)));
      row.add(count(wrong(scene, Metrics.CAROM)));
      for (Setting test : TESTS) {
        row.add(ReportNumbers.time(time(scene, test)));
        row.add(short2(factor(scene, test)) + " x");
        row.add(count(wrong(scene, test)));
      }
      table.row(row);
    }
    return table.build();
  }

  private static String count(double wrong) {
    return Double.isNaN(wrong) ? "not asked" : ReportNumbers.count(wrong);
  }

  /** Where plain doubles do as well. */
  String asGood() {
    List<String> good =
        classes().stream()
            .filter(scene -> wrong(scene, PLAIN) == 0)
            .map(Metrics::queryClass)
            .toList();
    int n = classes().size();
    if (n == 0) {
      return "";
    }
    return good.isEmpty()
        ? "In every class plain doubles give some wrong answers."
        : "In %d of %d classes plain doubles made no wrong decision either: %s. There exactness buys nothing but the proof."
            .formatted(good.size(), n, String.join(", ", good));
  }

  /** The scenes with both controls. */
  private List<String> scenes() {
    return results.scenes(Metrics.FRAME_TIME).stream()
        .filter(scene -> standing(scene, PLAIN_GRID).isPresent())
        .filter(scene -> standing(scene, Metrics.CAROM).isPresent())
        .toList();
  }

  private Optional<Standing> standing(String scene, Setting setting) {
    return Standing.all(results, scene).stream()
        .filter(s -> s.setting().equals(setting) && !s.failed())
        .findFirst();
  }

  private double frame(String scene, Setting setting) {
    return standing(scene, setting).map(s -> s.time().middle()).orElse(Double.NaN);
  }

  /** A row for each scene; nothing if the controls were not measured. */
  ReportTable frames() {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "the median frame of",
            "Carom",
            "plain + grid",
            "Carom takes",
            "textbook + grid",
            "textbook double",
            "the grid gives",
            "error: Carom",
            "error: plain + grid",
            "error: textbook + grid");
    for (String scene : scenes()) {
      double carom = frame(scene, Metrics.CAROM);
      table.row(
          scene,
          ReportNumbers.time(carom),
          ReportNumbers.time(frame(scene, PLAIN_GRID)),
          ReportNumbers.ratio(Math.round(100 * carom / frame(scene, PLAIN_GRID)) / 100.0) + " x",
          ReportNumbers.time(frame(scene, GRID)),
          ReportNumbers.time(frame(scene, TEXTBOOK)),
          short2(frame(scene, TEXTBOOK) / frame(scene, GRID)) + " x",
          error(scene, Metrics.CAROM),
          error(scene, PLAIN_GRID),
          error(scene, GRID));
    }
    return table.build();
  }

  private String error(String scene, Setting setting) {
    return standing(scene, setting).map(s -> ReportNumbers.error(s.error())).orElse("failed");
  }

  String framesTitle() {
    double[] costs =
        scenes().stream()
            .mapToDouble(s -> frame(s, Metrics.CAROM) / frame(s, PLAIN_GRID))
            .sorted()
            .toArray();
    double[] gains =
        scenes().stream()
            .mapToDouble(s -> frame(s, TEXTBOOK) / frame(s, GRID))
            .filter(Double::isFinite)
            .sorted()
            .toArray();
    if (costs.length == 0 || gains.length == 0) {
      return "What a grid gives and what exactness costs a frame was not measured";
    }
    double least = costs[0];
    double most = costs[costs.length - 1];
    String cost =
        most <= 1
            ? "in a frame exactness shows no price: Carom takes %s to %s of the time of a simple program in plain doubles"
            : "a frame of Carom takes %s to %s times as long as a simple program in plain doubles";
    return "The grid makes frames %s to %s times as fast; "
            .formatted(short2(gains[0]), short2(gains[gains.length - 1]))
        + cost.formatted(ReportNumbers.ratio(round(least)), ReportNumbers.ratio(round(most)));
  }

  private static double round(double ratio) {
    return Math.round(100 * ratio) / 100.0;
  }

  /** In how many scenes plain doubles err no more. */
  String framesAsGood() {
    List<String> less = new ArrayList<>();
    List<String> same = new ArrayList<>();
    for (String scene : scenes()) {
      double ours = error(scene, Metrics.CAROM, Double.NaN);
      double theirs = error(scene, PLAIN_GRID, error(scene, TEXTBOOK, Double.NaN));
      if (theirs < ours) {
        less.add(scene);
      } else if (theirs == ours) {
        same.add(scene);
      }
    }
    if (scenes().isEmpty()) {
      return "";
    }
    String all =
        "In a single frame plain doubles are as accurate as Carom in %s and more accurate in %s.";
    return all.formatted(list(same), list(less))
        + " What they lack is right decisions where it is close, which single frames of these scenes"
        + " hardly meet.";
  }

  private static String list(List<String> scenes) {
    return scenes.isEmpty() ? "no scene" : String.join(", ", scenes);
  }

  private double error(String scene, Setting setting, double other) {
    return standing(scene, setting).map(Standing::error).orElse(other);
  }
}
