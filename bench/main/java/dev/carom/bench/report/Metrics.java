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
  static final String ENERGY_DRIFT = "drift_energy";
  static final String PENETRATION_DRIFT = "drift_penetration";

  private static final String QUERY = "query:";
  private static final String DEFAULTS = "default";

  /** The knob of a peer, which is left as it comes or set as well as its documentation allows. */
  private static final String PEER = "setting=";

  private Metrics() {}

  /** The class of a scene that stands for queries. */
  static String queryClass(String scene) {
    return (scene.startsWith(QUERY) ? scene.substring(QUERY.length()) : scene).replace('_', ' ');
  }

  /** The label of a dot: the value of the knob, or a short name for the long setting of a peer. */
  static String shortKnob(Setting setting) {
    if (isDefault(setting)) {
      return "defaults";
    }
    return setting.knob().startsWith(PEER) ? "tuned" : setting.value();
  }

  /** A method in words and its whole setting. */
  static String fullName(Setting setting) {
    return new Setting(Glossary.name(setting.method()), setting.knob()).toString();
  }

  /** A method in words and what stands at its dot. */
  static String shortName(Setting setting) {
    return (Glossary.name(setting.method()) + " " + shortKnob(setting)).strip();
  }

  /** Whether it is a physics engine, which is compared as it comes and tuned. */
  static boolean isEngine(Setting setting) {
    return setting.knob().startsWith(PEER);
  }

  /** Whether a peer is left as it comes. */
  static boolean isDefault(Setting setting) {
    return setting.value().startsWith(DEFAULTS);
  }
}
