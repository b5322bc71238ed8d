// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.util.ArrayList;
import java.util.List;

/**
 * The names at the dots of a panel. Names of methods whose dots cover each other are one text:
 * single ones would stand around a spot where nobody can tell whose is whose.
 */
final class DotNames {

  /** Marks nearer than this, in px, cover each other. */
  private static final double COVERED = 7;

  /** A text is broken after a name that ends beyond so many characters. */
  private static final int LINE = 20;

  private record Name(double x, double y, String text) {

    boolean isAt(Name other) {
      return Math.hypot(x - other.x, y - other.y) < COVERED;
    }
  }

  private final List<Name> methods = new ArrayList<>();

  /** Names a method at one of its dots. */
  void add(double x, double y, String text) {
    methods.add(new Name(x, y, text));
  }

  private String joined(List<Name> here) {
    StringBuilder text = new StringBuilder(here.get(0).text);
    int line = text.length();
    for (Name name : here.subList(1, here.size())) {
      boolean broken = line + name.text.length() > LINE;
      text.append(broken ? ",\n" : ", ").append(name.text);
      line = (broken ? 0 : line) + name.text.length();
    }
    return text.toString();
  }

  void addTo(DotLabels labels) {
    List<Name> left = new ArrayList<>(methods);
    while (!left.isEmpty()) {
      Name first = left.get(0);
      List<Name> here = left.stream().filter(first::isAt).toList();
      left.removeAll(here);
      labels.add(first.x, first.y, joined(here));
    }
  }
}
