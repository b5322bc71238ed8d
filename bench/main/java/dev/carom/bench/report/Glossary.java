// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/** What the methods are, in a sentence each. */
final class Glossary {

  private static final Map<String, String> METHODS = new LinkedHashMap<>();

  static {
    METHODS.put("carom", "this library");
    METHODS.put(
        "poster",
        "the published algorithm, in float: every circle asks every line, one impact a frame");
    METHODS.put("poster-double", "the published algorithm in double");
    METHODS.put("textbook-float", "all impacts, each by the quadratic of the textbooks, in float");
    METHODS.put("textbook-double", "the same in double");
    METHODS.put("plain", "a careful test in plain doubles, without exact arithmetic");
    METHODS.put(
        "advancement", "all impacts by conservative advancement; knob: the tolerance of distance");
    METHODS.put("closest-point", "distances at samples of the motion; knob: how many");
    METHODS.put("overlap", "an overlap test at the end of the frame");
    METHODS.put("substeps", "overlap tests within the frame; knob: how many");
    METHODS.put("dyn4j", "a physics engine in Java");
    METHODS.put("jbox2d", "a physics engine in Java, Box2D translated");
    METHODS.put("gdx-box2d", "Box2D itself, in C++, as libGDX ships it");
    METHODS.put(Metrics.NEIGHBOUR, "carom from a start that differs by one unit in the last place");
  }

  private Glossary() {}

  /** By method, in an order in which they explain each other. */
  static Map<String, String> methods() {
    return Collections.unmodifiableMap(METHODS);
  }
}
