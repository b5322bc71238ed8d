// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

/** Spaces, numbers and quotations in the rows of a scene file. */
final class SceneText {

  private static final int QUOTED_CHARS = 40;

  private SceneText() {}

  /** Counts a char in the text before {@code end}. */
  static int count(char c, String text, int end) {
    int count = 0;
    for (int i = text.indexOf(c); i >= 0 && i < end; i = text.indexOf(c, i + 1)) {
      count++;
    }
    return count;
  }

  /**
   * The index of the first char from {@code from} to {@code to} that is not a space or tab; {@code
   * to} if there is none.
   */
  static int start(String text, int from, int to) {
    int start = from;
    while (start < to && isSpace(text.charAt(start))) {
      start++;
    }
    return start;
  }

  /**
   * The index after the last char from {@code from} to {@code to} that is not a space or tab;
   * {@code from} if there is none.
   */
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
   * Parses a decimal or hexadecimal number and rounds it to the nearest double. Any other text is
   * NaN, and so is a number beyond the range of a double. {@link Double#parseDouble} accepts more:
   * control chars around the number, NaN, Infinity, and a type suffix (1.5f). Each of these shows
   * in the first or the last char.
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
   * The text in quotation marks, cut after {@value #QUOTED_CHARS} chars. Quotation marks,
   * backslashes, and all chars that are not printable ASCII are escaped.
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
