// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.Uncertainty;
import dev.carom.World;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.reference.References;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The bound that an {@link Uncertainty} gives for the error of a place, beside the true error: at
 * each circle and frame until the bound reaches the circle's radius. The bounds are told by decade
 * of the error.
 *
 * @param scene one with a stored reference
 */
record TrustPart(String scene) implements Part {

  /** The bounds at places whose errors are in the same decade. */
  static final String BOUND = "error_bound";

  /** The bound of a place over its error. */
  static final String RATIO = "error_bound_ratio";

  /** At how many places the error exceeds the bound. */
  static final String EXCEEDED = "error_bound_exceeded";

  private final class Places {
    private final Map<Integer, List<Double>> bounds = new TreeMap<>();
    private final List<Double> ratios = new ArrayList<>();
    private long exceeded;

    /** Both in radii. An error below the rounding of the reference is told as that. */
    void add(double bound, double error, double rounding) {
      double told = Math.max(error, rounding);
      int decade = (int) Math.floor(Math.log10(told));
      bounds.computeIfAbsent(decade, any -> new ArrayList<>()).add(bound);
      ratios.add(bound / told);
      exceeded += error - rounding > bound ? 1 : 0;
    }

    List<Row> rows() {
      Trial trial = new Trial(scene, Methods.CAROM);
      List<Row> rows = new ArrayList<>();
      bounds.forEach(
          (decade, all) -> {
            Quantiles q = quantiles(all);
            rows.add(trial.row(BOUND, "p5@" + decade, q.at(0.05), Trial.RADII, q.size()));
            rows.add(trial.row(BOUND, "median@" + decade, q.median(), Trial.RADII, q.size()));
            rows.add(trial.row(BOUND, "p95@" + decade, q.at(0.95), Trial.RADII, q.size()));
          });
      Quantiles q = quantiles(ratios);
      rows.add(trial.row(RATIO, "median", q.median(), Trial.ONE, q.size()));
      rows.add(trial.row(EXCEEDED, "count", (double) exceeded, Trial.ONE, q.size()));
      rows.add(trial.row(EXCEEDED, "of", q.size(), Trial.ONE, q.size()));
      return rows;
    }
  }

  private static Quantiles quantiles(List<Double> values) {
    return new Quantiles(values.stream().mapToDouble(v -> v).toArray());
  }

  @Override
  public String id() {
    return "scene/" + scene + "/trust";
  }

  @Override
  public double seconds() {
    return 0.5;
  }

  @Override
  public List<Row> run() {
    try {
      return measure(References.scene(scene), References.load(scene));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Follows a scene along its true course. */
  List<Row> measure(Scene start, Reference truth) {
    World world = new World(start);
    Uncertainty uncertainty = world.uncertainty(1);
    boolean[] isKnown = new boolean[truth.circles()];
    Arrays.fill(isKnown, true);
    Places places = new Places();
    for (int frame = 1; frame <= truth.frames(); frame++) {
      world.advanceTo(frame);
      for (int i = 0; i < isKnown.length; i++) {
        double radius = world.radius(i);
        double bound = uncertainty.bound(i);
        isKnown[i] &= bound < radius;
        if (isKnown[i]) {
          double x = truth.x(frame, i);
          double y = truth.y(frame, i);
          double error = Math.hypot(world.x(i) - x, world.y(i) - y);
          double rounding = Math.hypot(Math.ulp(x), Math.ulp(y)) / 2;
          places.add(bound / radius, error / radius, rounding / radius);
        }
      }
    }
    return places.rows();
  }
}
