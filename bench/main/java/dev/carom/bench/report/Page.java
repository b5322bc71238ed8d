// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Picture;
import dev.carom.bench.charts.Style;
import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.awt.Color;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The report as one page: verdict, ratios, figures, each with its caption as alternative text and a
 * table behind it, and where it all comes from. It needs no network, and its colours follow the
 * reader's choice of light or dark.
 */
final class Page {

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
  private final StringBuilder html = new StringBuilder();
  private final Results results;
  private final List<Figure> figures;

  private Page(Results results, List<Figure> figures) {
    this.results = results;
    this.figures = figures;
  }

  static String of(Results results, List<Figure> figures) throws IOException {
    Page page = new Page(results, figures);
    page.head();
    page.verdict();
    page.ratios();
    page.limits();
    for (int i = 0; i < figures.size(); i++) {
      page.figure(figures.get(i), "f" + i + "-");
    }
    page.shortcomings();
    page.methods();
    page.origin();
    page.styles();
    page.html.append("</main>\n</body>\n</html>\n");
    return page.html.toString();
  }

  private void head() throws IOException {
    html.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n")
        .append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n")
        .append("<title>Carom: speed and accuracy</title>\n<style>\n")
        .append(style())
        .append("</style>\n</head>\n<body>\n<main>\n<h1>Carom: speed and accuracy</h1>\n");
    Metadata m = results.metadata();
    String run = m.quick() ? "Short run of " : "Run of ";
    html.append("<p class=\"machine\">")
        .append(text(run + m.date() + " on " + m.cpu() + ", " + m.cores() + " cores, " + m.jdk()))
        .append("</p>\n");
  }

  private static String style() throws IOException {
    try (InputStream css = Page.class.getResourceAsStream("report.css")) {
      return new String(css.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private void verdict() {
    html.append("<ul class=\"verdict\">\n");
    for (String sentence : Verdict.of(results)) {
      int colon = sentence.indexOf(':');
      String rest = sentence.substring(colon + 1).strip();
      html.append("<li><b>")
          .append(text(sentence.substring(0, colon)))
          .append("</b>")
          .append(text(rest.substring(0, 1).toUpperCase(Locale.ROOT) + rest.substring(1)))
          .append("</li>\n");
    }
    html.append("</ul>\n<nav aria-label=\"Figures\"><ul>\n");
    for (Figure figure : figures) {
      html.append("<li><a href=\"#")
          .append(text(figure.id()))
          .append("\">")
          .append(text(figure.heading()))
          .append("</a></li>\n");
    }
    html.append("</ul></nav>\n");
  }

  private void ratios() {
    ReportTable ratios = Ratios.of(results);
    if (!ratios.rows().isEmpty()) {
      html.append("<h2>How many times as long as carom the others take</h2>\n");
      table(ratios, "Ratios of times");
      html.append("<p class=\"machine\">Medians; in brackets the least and the greatest that the")
          .append(" forks allow. Below 1 the other is faster.</p>\n");
    }
  }

  private void limits() {
    html.append("<h2>The limits, and whether they hold</h2>\n");
    table(AcceptanceLimits.table(results), "Limits");
    AcceptanceLimits.note(results)
        .ifPresent(
            note -> html.append("<p class=\"machine\">").append(text(note)).append("</p>\n"));
  }

  private void shortcomings() {
    html.append("<h2>Where carom is not the best, and what was not asked</h2>\n<ul>\n");
    Shortcomings.of(results)
        .forEach(told -> html.append("<li>").append(text(told)).append("</li>\n"));
    html.append("</ul>\n");
  }

  private void figure(Figure figure, String prefix) {
    html.append("<section id=\"").append(text(figure.id())).append("\">\n<h2>");
    html.append(text(figure.heading())).append("</h2>\n<figure>\n");
    picture(figure, figure.picture(), "wide", prefix);
    picture(figure, figure.narrow(), "narrow", prefix + "n-");
    String first = firstSentence(figure.caption());
    html.append("<figcaption>").append(text(first)).append("</figcaption>\n");
    html.append("</figure>\n<details><summary>The numbers</summary>\n");
    String rest = figure.caption().substring(first.length()).strip();
    if (!rest.isEmpty()) {
      html.append("<p>").append(text(rest)).append("</p>\n");
    }
    table(figure.table(), figure.heading());
    html.append("</details>\n</section>\n");
  }

  /** What the picture shows; what else there is to know stands with the numbers. */
  private static String firstSentence(String caption) {
    int end = caption.indexOf(". ");
    return end < 0 ? caption : caption.substring(0, end + 1);
  }

  /** The page shows one of the two, by its own width. */
  private void picture(Figure figure, Picture picture, String layout, String prefix) {
    String label = "<svg role=\"img\" aria-label=\"" + text(figure.caption()) + "\" ";
    html.append("<div class=\"picture ").append(layout).append("\">");
    html.append(classed(themed(picture.svg(prefix))).replaceFirst("<svg ", quoted(label)));
    html.append("</div>\n");
  }

  private static String quoted(String replacement) {
    return Matcher.quoteReplacement(replacement);
  }

  /** What thousands of marks have in common is written once: it is a third of all. */
  private String classed(String svg) {
    return STYLE
        .matcher(svg)
        .replaceAll(
            match -> {
              int next = styles.size();
              int index = styles.computeIfAbsent(match.group(1), none -> next);
              return "class='s" + index + "'";
            });
  }

  private void styles() {
    html.append("<style>\n");
    styles.forEach((style, index) -> html.append(".s%d{%s}\n".formatted(index, style)));
    html.append("</style>\n");
  }

  /** Colours by name, so that the page decides what they are. */
  private static String themed(String svg) {
    String themed = svg;
    for (Map.Entry<Color, String> entry : NAMES.entrySet()) {
      Color c = entry.getKey();
      String rgb = "rgb(%d,%d,%d)".formatted(c.getRed(), c.getGreen(), c.getBlue());
      themed = themed.replace(rgb, "var(--" + entry.getValue() + ")");
    }
    return themed;
  }

  private void table(ReportTable table, String label) {
    html.append("<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"")
        .append(text(label))
        .append(": numbers\"><table>\n<thead><tr>");
    table.head().forEach(cell -> html.append("<th>").append(text(cell)).append("</th>"));
    html.append("</tr></thead>\n<tbody>\n");
    for (List<String> row : table.rows()) {
      html.append("<tr>");
      // HTML lets cells and rows end where the next one begins: of 14,000 that is a 50th of the
      // page.
      row.forEach(cell -> html.append("<td>").append(text(cell)));
      html.append('\n');
    }
    html.append("</tbody></table></div>\n");
  }

  private void methods() {
    Map<String, String> told = new LinkedHashMap<>(Glossary.methods());
    told.keySet().retainAll(results.methods());
    if (!told.isEmpty()) {
      html.append("<h2>What the methods are</h2>\n<dl>\n");
      told.forEach(this::item);
      html.append("</dl>\n");
    }
  }

  private void origin() {
    Metadata m = results.metadata();
    html.append("<h2>Where these numbers come from</h2>\n<dl>\n");
    item("processor", m.cpu() + ", " + m.cores() + " cores");
    item("system", m.os());
    item("virtual machine", (m.jdk() + " " + m.flags()).strip());
    item("commit", m.commit());
    m.scenes().forEach((scene, hash) -> item("scene " + scene, "SHA-256 " + hash));
    m.seeds().forEach((name, seed) -> item("seed " + name, Long.toString(seed)));
    item("rows", ReportNumbers.count(results.rows().size()));
    failures().forEach(failure -> item("not measured", failure));
    html.append("</dl>\n");
  }

  /** Who failed where and why, each once. */
  private List<String> failures() {
    return results.rows().stream()
        .filter(row -> row.metric().equals(ReportRun.FAILURE))
        .map(
            row ->
                "%s %s: %s"
                    .formatted(row.scene(), new Setting(row.method(), row.knob()), row.stat()))
        .distinct()
        .toList();
  }

  private void item(String name, String value) {
    html.append("<dt>").append(text(name)).append("</dt><dd>").append(text(value));
    html.append("</dd>\n");
  }

  private static String text(String plain) {
    return plain
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
