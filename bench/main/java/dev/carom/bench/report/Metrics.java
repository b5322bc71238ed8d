// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Setting;

/** The names of metrics and scenes in the rows, and the methods that have a part of their own. */
final class Metrics {

  static final String OURS = "carom";
  static final Setting CAROM = new Setting(OURS, "");

  /** The true course, begun in the neighbouring double: no method in doubles can be better. */
  static final String NEIGHBOUR = "reference+1ulp";

  static final String FRAME_TIME = "frame_time";
  static final String FRAME_RAW = "frame_raw";
  static final String RUNGS = "rungs";
  static final String GAS_ENERGY = "gas_energy";
  static final String GAS_OVERLAP = "gas_overlap";
  static final String GAS_LOST = "gas_lost";
  static final String HEAP_OVERLAP = "heap_overlap";
  static final String HEAP_ENERGY = "heap_energy";
  static final String HEAP_REST = "heap_rest";
  static final String BOUNCE = "bounce";
  static final String BOUNCE_ENERGY = "bounce_energy";
  static final String ERROR_BOUND = "error_bound";
  static final String ERROR_BOUND_RATIO = "error_bound_ratio";
  static final String ERROR_BOUND_EXCEEDED = "error_bound_exceeded";
  static final String FRAME_ERROR = "frame_error";
  static final String HORIZON = "horizon";
  static final String MISSED = "decisions_missed";
  static final String INVENTED = "decisions_false";
  static final String DECISIONS = "decisions_total";
  static final String TIME_ERROR = "time_error";
  static final String QUERY_TIME = "query_time";
  static final String PAIR_TESTS = "pair_tests";
  static final String TRAJECTORY_DRIFT = "drift_trajectory";

  private static final String QUERY = "query:";

  private Metrics() {}

  /** The class of a scene that stands for queries. */
  static String queryClass(String scene) {
    return scene.replace(QUERY, "").replace('_', ' ');
  }
}
