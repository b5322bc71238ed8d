// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/** The methods, in a sentence each. */
final class Glossary {

  private static final Map<String, String> METHODS = new LinkedHashMap<>();

  /** Short enough to stand at a dot. */
  private static final Map<String, String> NAMES = new LinkedHashMap<>();

  static {
    add("carom", "Carom", "this library");
    add(
        "poster",
        "published 2010",
        "the published algorithm of 2010, in float: every circle asks every line, one impact a"
            + " frame");
    add("poster-double", "published double", "the same algorithm in doubles");
    add(
        "textbook-float",
        "textbook float",
        "all impacts of a frame, each by the quadratic equation of the textbooks, in float");
    add("textbook-double", "textbook double", "the same in doubles; every circle asks every line");
    add(
        "textbook-grid",
        "textbook + grid",
        "the same in doubles, asking only lines of the cells on the way, as Carom does: a control"
            + " for what the grid gives");
    add(
        "plain-grid",
        "plain + grid",
        "a simple program in plain doubles with a grid like Carom's and a filter, without its"
            + " guarantees: a control for what exactness costs");
    add("plain", "plain doubles", "Carom's own test of one line, in plain doubles");
    add(
        "advancement",
        "advancement",
        "all impacts by conservative advancement; its knob is the tolerance of distance");
    add("closest-point", "sampled", "distances at samples of the motion; its knob is how many");
    add("overlap", "overlap test", "an overlap test at the end of the frame, and pushing out");
    add("substeps", "substeps", "overlap tests within the frame; its knob is how many");
    add("dyn4j", "dyn4j", "dyn4j 6.0.0, a physics engine in Java");
    add("jbox2d", "JBox2D", "JBox2D 2.2.1.1, Box2D 2 translated to Java");
    add("gdx-box2d", "Box2D", "Box2D 2, in C++, as libGDX 1.14.2 ships it");
    add(
        Metrics.NEIGHBOUR,
        "1 ulp away",
        "the true course from a start that differs by one unit in the last place");
  }

  private static void add(String method, String name, String what) {
    METHODS.put(method, what);
    NAMES.put(method, name);
  }

  /** How a method is called where people read; one that is not known keeps its label. */
  static String name(String method) {
    return NAMES.getOrDefault(method, method);
  }

  /** Whether a method was only written to tell what a part of carom gives. */
  static boolean isControl(String method) {
    return METHODS.getOrDefault(method, "").contains("a control for");
  }

  private Glossary() {}

  /** By method, in an order in which they explain each other. */
  static Map<String, String> methods() {
    return Collections.unmodifiableMap(METHODS);
  }
}
