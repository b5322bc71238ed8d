// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Picture;
import dev.carom.bench.charts.Style;
import java.awt.Color;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Pictures as parts of a page, which decides about their colours. */
final class InlineSvg {

  /** The names that the page has for colours. */
  private static final Map<Color, String> NAMES = new LinkedHashMap<>();

  static {
    NAMES.put(Style.PAPER, "paper");
    NAMES.put(Style.FLOOR, "floor");
    NAMES.put(Style.INK, "ink");
    NAMES.put(Style.QUIET, "quiet");
    NAMES.put(Style.GRID, "grid");
    NAMES.put(Style.BLUE, "blue");
    NAMES.put(Style.SKY, "sky");
    NAMES.put(Style.GREEN, "green");
    NAMES.put(Style.ORANGE, "orange");
    NAMES.put(Style.VERMILION, "vermilion");
    NAMES.put(Style.PURPLE, "purple");
    NAMES.put(Style.YELLOW, "yellow");
  }

  private static final Pattern STYLE = Pattern.compile("style='([^']*)'");

  private final Map<String, Integer> styles = new LinkedHashMap<>();
  private int pictures;

  /** A picture. Its label is short, for words beside the picture say the rest. */
  String of(Picture picture) {
    String prefix = "p" + pictures++ + "-";
    String label = "<svg role=\"img\" aria-label=\"" + Page.text(picture.title()) + "\" ";
    String svg = slim(classed(themed(picture.svg(prefix))));
    return "<div class=\"picture\">"
        + svg.replaceFirst("<svg ", Matcher.quoteReplacement(label))
        + "</div>\n";
  }

  /**
   * Without what a page has no use for: name spaces, groups of one text, a title beside the label,
   * and the clip of whole charts, which is the first of each.
   */
  private static String slim(String svg) {
    return svg.replaceAll(" xmlns:?[a-z]*='[^']*'", "")
        .replaceAll("<g>(<text [^>]*>[^<]*</text>)</g>", "$1")
        .replaceFirst("<title>[^<]*</title>", "")
        .replaceAll(" clip-path='url\\(#p[0-9]+-clip-0\\)'", "");
  }

  /** Writes styles shared by thousands of marks once. They are a third of the page. */
  private String classed(String svg) {
    return STYLE
        .matcher(svg)
        .replaceAll(
            match -> {
              int next = styles.size();
              return "class='s" + styles.computeIfAbsent(match.group(1), none -> next) + "'";
            });
  }

  /** The styles of all pictures so far. */
  String styles() {
    return styles.entrySet().stream()
        .map(style -> ".s" + style.getValue() + "{" + style.getKey() + "}\n")
        .collect(Collectors.joining());
  }

  /** Colours by name, so that the page decides what they are. */
  private static String themed(String svg) {
    String themed = svg;
    for (Map.Entry<Color, String> entry : NAMES.entrySet()) {
      Color c = entry.getKey();
      String rgb = "rgb(" + c.getRed() + "," + c.getGreen() + "," + c.getBlue() + ")";
      themed = themed.replace(rgb, "var(--" + entry.getValue() + ")");
    }
    return themed;
  }
}
