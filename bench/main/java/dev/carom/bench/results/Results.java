// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** All that was measured, and where. Scenes and settings keep the order of the rows. */
public final class Results {

  private record Key(String scene, Setting setting, String metric, String stat) {}

  private final Metadata metadata;
  private final List<Row> rows;
  private final Map<Key, List<Row>> index = new LinkedHashMap<>();
  private final Map<String, Set<Key>> byMetric = new LinkedHashMap<>();

  /**
   * Puts rows together.
   *
   * @param metadata where they come from
   * @param rows any number, in any order
   */
  public Results(Metadata metadata, List<Row> rows) {
    this.metadata = metadata;
    this.rows = List.copyOf(rows);
    for (Row row : rows) {
      Setting setting = new Setting(row.method(), row.knob());
      Key key = new Key(row.scene(), setting, row.metric(), row.stat());
      index.computeIfAbsent(key, none -> new ArrayList<>()).add(row);
      byMetric.computeIfAbsent(row.metric(), none -> new LinkedHashSet<>()).add(key);
    }
  }

  /** Where the rows come from. */
  public Metadata metadata() {
    return metadata;
  }

  /** Every measured number, in the order given. */
  public List<Row> rows() {
    return rows;
  }

  /**
   * Where a metric was measured.
   *
   * @param metric its name
   */
  public List<String> scenes(String metric) {
    return keys(metric, key -> true).map(Key::scene).distinct().toList();
  }

  /**
   * Returns the settings for which a metric was measured.
   *
   * @param metric its name
   */
  public List<Setting> settings(String scene, String metric) {
    return keys(metric, key -> key.scene.equals(scene)).map(Key::setting).distinct().toList();
  }

  /** Every method of every row: their labels. */
  public Set<String> methods() {
    Set<String> methods = new LinkedHashSet<>();
    index.keySet().forEach(key -> methods.add(key.setting.method()));
    return methods;
  }

  /**
   * One number over all forks.
   *
   * @param setting the method and its knob
   * @param metric what was measured
   * @return its spread, or nothing if it was not measured
   */
  public Optional<Spread> spread(String scene, Setting setting, String metric, String stat) {
    List<Row> found = index.get(new Key(scene, setting, metric, stat));
    if (found == null) {
      return Optional.empty();
    }
    double[] values = found.stream().mapToDouble(Row::value).toArray();
    return Optional.of(Spread.of(found.stream().mapToLong(Row::n).sum(), values));
  }

  /**
   * The number of a metric that has but one stat, whatever that is called.
   *
   * @param setting the method and its knob
   * @param metric what was measured
   * @return its spread, or nothing if it was not measured
   */
  public Optional<Spread> only(String scene, Setting setting, String metric) {
    return keys(metric, key -> key.scene.equals(scene) && key.setting.equals(setting))
        .findFirst()
        .flatMap(key -> spread(scene, setting, metric, key.stat));
  }

  /**
   * The median over forks of one number.
   *
   * @param setting the method and its knob
   * @param metric what was measured
   * @return the number, NaN if it failed or was not measured
   */
  public double value(String scene, Setting setting, String metric, String stat) {
    return spread(scene, setting, metric, stat).map(Spread::middle).orElse(Double.NaN);
  }

  /**
   * A series by frame: the numbers whose stat is {@code name@frame}, the median over forks of each.
   *
   * @param setting the method and its knob
   * @param metric what was measured
   * @return frames and values, in the order of the rows
   */
  public Map<Integer, Double> series(String scene, Setting setting, String metric, String name) {
    Map<Integer, Double> series = new LinkedHashMap<>();
    keys(
            metric,
            key ->
                key.scene.equals(scene)
                    && key.setting.equals(setting)
                    && key.stat.startsWith(name + "@"))
        .forEach(
            key ->
                series.put(
                    Integer.valueOf(key.stat.substring(name.length() + 1)),
                    value(scene, setting, metric, key.stat)));
    return series;
  }

  private Stream<Key> keys(String metric, Predicate<Key> wanted) {
    return byMetric.getOrDefault(metric, Set.of()).stream().filter(wanted);
  }
}
