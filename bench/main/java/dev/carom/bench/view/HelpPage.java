// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.util.List;

/** The texts of the Help menu. */
final class HelpPage {

  private static final List<String[]> MOUSE =
      List.of(
          new String[] {"Wheel", "Zoom at the mouse"},
          new String[] {"Drag the floor", "Pan; with the right button anywhere"},
          new String[] {"Double click", "Show the whole scene"},
          new String[] {"Rest on a circle", "Its place, speed and radius"},
          new String[] {"Drag a circle", "Move it; let go while it moves to throw it"},
          new String[] {"Drag a line or peg", "Move it; a line by its ends, too"});

  private HelpPage() {}

  /** All keys, and what the mouse does. */
  static String html(List<KeyAction> keys) {
    StringBuilder page = new StringBuilder("<html><table cellpadding=2>");
    for (KeyAction key : keys) {
      row(page, key.label(), key.tip());
    }
    row(page, "?", "This page");
    for (String[] entry : MOUSE) {
      row(page, entry[0], entry[1]);
    }
    return page.append("</table></html>").toString();
  }

  private static void row(StringBuilder page, String left, String right) {
    page.append("<tr><td><b>")
        .append(left)
        .append("</b></td><td>")
        .append(right)
        .append("</td></tr>");
  }

  static String about() {
    return "<html><b>Carom</b>: circles that move and bounce, exactly.<br>"
        + "Every impact is found and resolved at its own moment; the past can be shown again,"
        + " to the bit.</html>";
  }
}
