// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/**
 * A small made-up data set, in which carom is best everywhere; tests change what they are about.
 */
final class Sample {

  static final int FORKS = 5;

  static final Metadata METADATA =
      new Metadata(
          "a processor",
          2,
          "an os",
          "a jdk",
          "",
          "0123456789abcdef",
          Map.of("base-1", "00ff"),
          Map.of("sweep", 1L),
          "2026-01-02",
          true);

  private final List<Row> rows = new ArrayList<>();

  /** Everything that a report can show. */
  static Sample complete() {
    Sample sample = new Sample();
    for (String scene : List.of("base-1", "fast-1")) {
      sample.frames(scene, "carom", "", 1000, 3e-16, 12);
      sample.frames(scene, "poster", "", 66_000, 0.9, 10_000);
      sample.frames(scene, "textbook-double", "", 52_000, 4e-13, 10_000);
      sample.frames(scene, "overlap", "", 1500, Double.NaN, 9_000);
      sample.frames(scene, "exact", "", 1_560, 4e-16, 24);
      sample.frames(scene, "gdx-box2d", "setting=tuned", 40_000, 0.2, Double.NaN);
      for (int k = 2; k <= 256; k *= 4) {
        sample.frames(scene, "substeps", "k=" + k, 1400.0 * k, 0.8 / k, 9_000.0 * k);
      }
      for (int e = 2; e <= 12; e += 5) {
        sample.frames(
            scene, "advancement", "tolerance=1e-" + e, 6000.0 * e, Math.pow(10, -e), 8000.0 * e);
      }
      sample.frames(scene, "dyn4j", "setting=defaults, 30 px/m", 210_000, 0.4, Double.NaN);
      sample.frames(scene, "dyn4j", "setting=continuous, 10+ px/m", 330_000, 0.03, Double.NaN);
    }
    for (String kind : List.of("head-on", "grazing", "far_from_origin")) {
      sample.query(kind, "carom", "", 30, 0.5, 0, 0);
      sample.query(kind, "textbook-double", "", 45, 4e5, 31, 2);
      sample.query(kind, "textbook-float", "", 40, 5e9, 412, 99);
      sample.query(kind, "advancement", "tolerance=1e-7", 400, 3e11, 1203, 7);
    }
    sample.drift("base-1", "carom", 1e-15, 230);
    sample.drift("base-1", "poster", 1e-6, 12);
    sample.drift("base-1", "reference+1ulp", 1e-16, 236);
    sample.raw("base-1", "carom", 1000);
    sample.raw("base-1", "poster", 66_000);
    for (int n : List.of(1, 10, 50, 100)) {
      sample.sweep("circles=" + n, n);
      sample.sweep("radius=" + (1 + n / 10), 100);
      sample.sweep("lines=" + 2 * n, 100);
      sample.sweep("impacts=" + n / 10, 100);
    }
    return sample;
  }

  Results results() {
    return new Results(METADATA, rows);
  }

  /** Leaves out what is to be replaced. */
  Sample without(Predicate<Row> unwanted) {
    rows.removeIf(unwanted);
    return this;
  }

  Sample frames(
      String scene, String method, String knob, double nanos, double error, double tests) {
    for (int fork = 0; fork < FORKS; fork++) {
      double time = nanos * (1 + 0.02 * fork);
      add(scene, method, knob, "frame_time", "median", time, "ns", fork);
      add(scene, method, knob, "frame_time", "worst", 3 * time, "ns", fork);
    }
    add(scene, method, knob, "frame_error", "max", error, "radii", -1);
    add(scene, method, knob, "frame_error", "median", error / 100, "radii", -1);
    add(scene, method, knob, "pair_tests", "mean", tests, "1", -1);
    return this;
  }

  Sample query(
      String kind,
      String method,
      String knob,
      double nanos,
      double ulps,
      double missed,
      double invented) {
    String scene = "query:" + kind;
    for (int fork = 0; fork < FORKS; fork++) {
      add(scene, method, knob, "query_time", "median", nanos * (1 + 0.01 * fork), "ns", fork);
    }
    add(scene, method, knob, "time_error", "max", ulps, "ulps", -1);
    add(scene, method, knob, "decisions_missed", "count", missed, "1", -1);
    add(scene, method, knob, "decisions_false", "count", invented, "1", -1);
    add(scene, method, knob, "decisions_total", "count", 10_000, "1", -1);
    return this;
  }

  private void drift(String scene, String method, double start, double horizon) {
    for (int frame = 50; frame <= 600; frame += 50) {
      double error = Math.min(20, start * Math.exp(0.14 * frame));
      series(scene, method, "drift_trajectory", frame, error);
      series(scene, method, "drift_energy", frame, method.equals("carom") ? 0 : 1e-7 * frame);
      series(scene, method, "drift_penetration", frame, method.equals("carom") ? 0 : 1e-3);
    }
    add(scene, method, "", "horizon", "median", horizon, "frames", -1);
  }

  private void series(String scene, String method, String metric, int frame, double value) {
    add(scene, method, "", metric, "median@" + frame, value, "radii", -1);
    add(scene, method, "", metric, "p5@" + frame, value / 3, "radii", -1);
    add(scene, method, "", metric, "p95@" + frame, 3 * value, "radii", -1);
  }

  private void raw(String scene, String method, double nanos) {
    for (int frame = 0; frame < 60; frame++) {
      double time = nanos * (1 + 0.3 * Math.sin(frame * frame));
      add(scene, method, "", "frame_raw", "frame@" + frame, Math.rint(time), "ns", 0);
    }
  }

  private void sweep(String scene, int circles) {
    for (String method : List.of("carom", "poster")) {
      double nanos = method.equals("carom") ? 10 * circles : 660 * Math.pow(circles, 1.02);
      for (int fork = 0; fork < FORKS; fork++) {
        add("sweep:" + scene, method, "", "sweep_time", "mean", nanos, "ns", fork);
        add("sweep:" + scene, method, "", "sweep_time", "min", 0.7 * nanos, "ns", fork);
        add("sweep:" + scene, method, "", "sweep_time", "max", 2 * nanos, "ns", fork);
      }
    }
  }

  void add(
      String scene,
      String method,
      String knob,
      String metric,
      String stat,
      double value,
      String unit,
      int fork) {
    rows.add(new Row(scene, method, knob, metric, stat, value, unit, 600, fork));
  }
}
