// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

/** Spaces, numbers and quotations in the rows of a scene file. */
final class SceneText {

  private static final int QUOTED_CHARS = 40;

  private SceneText() {}

  /** How often a char stands before {@code end}. */
  static int count(char c, String text, int end) {
    int count = 0;
    for (int i = text.indexOf(c); i >= 0 && i < end; i = text.indexOf(c, i + 1)) {
      count++;
    }
    return count;
  }

  /** Where a text begins that stands between {@code from} and {@code to} with spaces around it. */
  static int start(String text, int from, int to) {
    int start = from;
    while (start < to && isSpace(text.charAt(start))) {
      start++;
    }
    return start;
  }

  /** Where a text ends that stands between {@code from} and {@code to} with spaces around it. */
  static int end(String text, int from, int to) {
    int end = to;
    while (end > from && isSpace(text.charAt(end - 1))) {
      end--;
    }
    return end;
  }

  private static boolean isSpace(char c) {
    return c == ' ' || c == '\t';
  }

  /**
   * The double nearest to a decimal or hex number; NaN for everything else, and beyond the range of
   * a double. {@link Double#parseDouble} takes more than that, but what more it takes shows at the
   * first or last char: control chars around the number, NaN, Infinity, and a type suffix (1.5f).
   */
  static double finite(String text) {
    if (text.isEmpty() || !isFirst(text.charAt(0)) || !isLast(text.charAt(text.length() - 1))) {
      return Double.NaN;
    }
    try {
      double number = Double.parseDouble(text);
      return Double.isInfinite(number) ? Double.NaN : number;
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  private static boolean isFirst(char c) {
    return isLast(c) || c == '+' || c == '-';
  }

  private static boolean isLast(char c) {
    return (c >= '0' && c <= '9') || c == '.';
  }

  /**
   * A text between quotation marks, cut short, with escapes for quotation marks, for backslashes,
   * and for what a terminal may not show.
   */
  static String quoted(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    for (int i = 0; i < Math.min(text.length(), QUOTED_CHARS); i++) {
      char c = text.charAt(i);
      if (c == '"' || c == '\\') {
        quoted.append('\\').append(c);
      } else if (c >= ' ' && c <= '~') {
        quoted.append(c);
      } else {
        quoted.append(String.format("\\u%04x", (int) c));
      }
    }
    return quoted.append(text.length() > QUOTED_CHARS ? "...\"" : "\"").toString();
  }
}
