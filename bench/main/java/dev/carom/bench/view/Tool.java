// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

/** The tools of the mouse. */
enum Tool {
  HAND("Hand", "Drag circles, lines, their ends and pegs; throw a circle; drag the floor to pan"),
  CIRCLE("Circle", "Add a circle: press, draw its velocity, release"),
  LINE("Line", "Add a line: press at one end, release at the other"),
  PEG("Peg", "Add a peg: press at its centre, release at its rim"),
  DELETE("Delete", "Delete the circle, line or peg that is clicked");

  private final String label;
  private final String tip;

  Tool(String label, String tip) {
    this.label = label;
    this.tip = tip;
  }

  String label() {
    return label;
  }

  String tip() {
    return tip;
  }
}
