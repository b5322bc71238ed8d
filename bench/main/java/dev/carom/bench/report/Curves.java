// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.series.Growth;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Lines of charts: along a series, or along scenes of growing size. */
final class Curves {

  private static final int LEAST_POINTS = 3;

  private Curves() {}

  /**
   * The line of a metric that is a series.
   *
   * @param stats the names of its lower end, its middle and its upper end
   * @param place where a number of the series stands
   */
  static Curve ofSeries(Standing s, String metric, List<String> stats, DoubleUnaryOperator place) {
    List<Map<Integer, Double>> series =
        stats.stream()
            .map(stat -> s.results().series(s.scene(), s.setting(), metric, stat))
            .toList();
    int[] at = series.get(1).keySet().stream().mapToInt(i -> i).sorted().toArray();
    List<double[]> values =
        series.stream()
            .map(numbers -> Arrays.stream(at).mapToDouble(numbers::get).toArray())
            .toList();
    double[] x = Arrays.stream(at).asDoubleStream().map(place).toArray();
    return new Curve(s.method(), "", x, values.get(0), values.get(1), values.get(2));
  }

  /** What was measured in scenes whose names are the prefix and a size. */
  static List<Standing> along(Results results, String metric, String prefix) {
    return results.scenes(metric).stream()
        .filter(scene -> scene.startsWith(prefix))
        .sorted((a, b) -> Integer.compare(size(a), size(b)))
        .flatMap(scene -> Standing.of(results, scene, metric).stream())
        .toList();
  }

  static int size(String scene) {
    return Integer.parseInt(scene.substring(scene.indexOf('=') + 1));
  }

  /**
   * A line for each setting, against the size of the scene.
   *
   * @param numbers the low, the middle and the high number of each
   */
  static List<Curve> ofScenes(List<Standing> standings, Function<Standing, double[]> numbers) {
    Map<Setting, List<Standing>> settings =
        standings.stream()
            .collect(
                Collectors.groupingBy(Standing::setting, LinkedHashMap::new, Collectors.toList()));
    List<Curve> curves = new ArrayList<>();
    settings.forEach(
        (setting, places) -> {
          double[] x = places.stream().mapToDouble(s -> size(s.scene())).toArray();
          List<double[]> y = places.stream().map(numbers).toList();
          curves.add(new Curve(setting.method(), "", x, part(y, 0), part(y, 1), part(y, 2)));
        });
    return curves;
  }

  private static double[] part(List<double[]> numbers, int part) {
    return numbers.stream().mapToDouble(n -> n[part]).toArray();
  }

  /** How the middle of a line grows, if it has enough numbers. */
  static Optional<Growth> growth(Curve curve) {
    int n = (int) Arrays.stream(curve.middle()).filter(v -> !Double.isNaN(v)).count();
    return n < LEAST_POINTS
        ? Optional.empty()
        : Optional.of(Growth.of(Arrays.copyOf(curve.x(), n), Arrays.copyOf(curve.middle(), n)));
  }

  /**
   * How lines grow: a sentence for each that has enough numbers.
   *
   * @param size the number that they grow with
   */
  static Stream<String> growth(String size, List<Curve> curves) {
    return curves.stream()
        .flatMap(
            curve ->
                growth(curve).stream()
                    .map(
                        fit ->
                            "The time of %s grows with the number of %s %s."
                                .formatted(Glossary.name(curve.method()), size, power(fit))));
  }

  static String power(Growth fit) {
    return String.format(
        Locale.ROOT,
        "to the power %.2f (%.2f .. %.2f at 95 %%)",
        fit.slope(),
        fit.low(),
        fit.high());
  }

  /**
   * A row for each point of each line.
   *
   * @param lines by what the first column says
   * @param head titles of the first column, the method, the place, the middle, and the two ends
   */
  static ReportTable table(
      Map<String, List<Curve>> lines, List<String> head, DoubleFunction<String> number) {
    List<List<String>> rows = new ArrayList<>();
    lines.forEach(
        (name, curves) -> {
          for (Curve curve : curves) {
            for (int i = 0; i < curve.x().length; i++) {
              rows.add(
                  List.of(
                      name,
                      ReportNumbers.count(curve.x()[i]),
                      Glossary.name(curve.method()),
                      number.apply(curve.middle()[i]),
                      number.apply(curve.low()[i]),
                      number.apply(curve.high()[i])));
            }
          }
        });
    return new ReportTable(head, rows);
  }
}
