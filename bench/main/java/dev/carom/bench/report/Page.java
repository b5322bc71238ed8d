// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Panel;
import dev.carom.bench.charts.Picture;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.Thumbnail;
import dev.carom.bench.measures.Parts;
import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import dev.carom.bench.stability.FailureMap;
import java.awt.Color;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The report as one page: a sentence, three numbers and a chart; then how to read it, and all
 * figures, each with its caption as alternative text and a table behind it. It needs no network,
 * and its colours follow the reader's choice of light or dark.
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

  private static final String COMMAND = "java -jar bench/target/carom-bench.jar report";

  /** The groups of the page, by the ids of their places. */
  private static final Map<String, String> GROUPS = new LinkedHashMap<>();

  static {
    GROUPS.put("read", "How to read this");
    GROUPS.put("accuracy", "Speed and accuracy");
    GROUPS.put("price", "The price of exactness");
    GROUPS.put("needs", "No more than a scene needs");
    GROUPS.put("stability", "Stability");
    GROUPS.put("many", "Many circles, and colliding ones");
    GROUPS.put("doubts", "Doubts, limits, origin");
  }

  private final Map<String, Integer> styles = new LinkedHashMap<>();
  private final StringBuilder html = new StringBuilder();
  private final Results results;
  private final Map<String, Figure> figures = new LinkedHashMap<>();
  private int pictures;

  private Page(Results results, List<Figure> figures) {
    this.results = results;
    figures.forEach(figure -> this.figures.put(figure.id(), figure));
  }

  static String of(Results results, List<Figure> figures) throws IOException {
    Page page = new Page(results, figures);
    page.head();
    page.firstScreen();
    page.read();
    page.accuracy();
    page.price();
    page.needs();
    page.stability();
    page.many();
    page.doubts();
    page.styles();
    page.html.append("</main>\n</body>\n</html>\n");
    return page.html.toString();
  }

  private void head() throws IOException {
    html.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n")
        .append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n")
        .append("<title>Carom: speed and accuracy</title>\n<style>\n")
        .append(style())
        .append("</style>\n</head>\n<body>\n")
        .append("<a class=\"skip\" href=\"#read\">Skip to how to read this</a>\n<main>\n");
  }

  private static String style() throws IOException {
    try (InputStream css = Page.class.getResourceAsStream("report.css")) {
      return new String(css.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private void firstScreen() {
    FirstScreen first = new FirstScreen(results);
    html.append("<p class=\"brand\">Carom: circles that move and bounce, measured</p>\n<h1>")
        .append(text(first.sentence()))
        .append("</h1>\n<div class=\"tiles\">\n");
    for (FirstScreen.Tile tile : first.tiles()) {
      html.append("<div class=\"tile\"><b>")
          .append(text(tile.name()))
          .append("</b><span class=\"value\">")
          .append(text(tile.value()))
          .append("</span><span>")
          .append(text(tile.what()))
          .append("</span><span class=\"quiet\">")
          .append(text(tile.rival()))
          .append("</span></div>\n");
    }
    html.append("</div>\n");
    figure("work-" + first.scene());
    html.append("<nav aria-label=\"Parts of this page\"><ul>\n");
    GROUPS.forEach(
        (id, name) ->
            html.append("<li><a href=\"#")
                .append(id)
                .append("\">")
                .append(text(name))
                .append("</a></li>\n"));
    html.append("</ul></nav>\n");
  }

  private void group(String id) {
    html.append("<h2 id=\"").append(id).append("\">").append(text(GROUPS.get(id)));
    html.append("</h2>\n");
  }

  private void paragraph(String plain) {
    if (!plain.isEmpty()) {
      html.append("<p>").append(text(plain)).append("</p>\n");
    }
  }

  private void read() {
    group("read");
    Metadata m = results.metadata();
    paragraph(
        "The error of a method: each frame starts from the true state of all circles, plays one"
            + " frame, and is compared with the true end of that frame. The true course is computed"
            + " to more digits than a double holds, and every decision in it is proved. So neither"
            + " errors of earlier frames count nor luck. Lengths are in px, times in frames; an error"
            + " is in radii of the circle. Circles ignore each other, as in the published"
            + " experiment; only in the gas they collide.");
    scenes();
    html.append("<details><summary>The methods, in words</summary>\n<dl>\n");
    methods();
    html.append("</dl></details>\n");
    String run = m.quick() ? "A short run of " : "Run of ";
    html.append("<p class=\"quiet\">")
        .append(
            text(
                run
                    + m.date()
                    + " on "
                    + m.cpu()
                    + ", "
                    + m.cores()
                    + " cores, "
                    + m.os()
                    + "; "
                    + (m.jdk() + " " + m.flags()).strip()
                    + "; commit "
                    + commit(m.commit())
                    + ". Measure again: "))
        .append("<code>")
        .append(text(COMMAND + (m.quick() ? " --quick" : "")))
        .append("</code>. Make this page from stored numbers: <code>")
        .append(text(COMMAND + " --from bench/results --out DIR"))
        .append("</code>.</p>\n");
  }

  private static String commit(String commit) {
    String age = Age.of(commit);
    String bare = commit.length() > 12 ? commit.substring(0, 12) : commit;
    return age.isEmpty() ? bare : bare + ", " + age;
  }

  private void scenes() {
    List<String> measured = new ArrayList<>(results.scenes(Metrics.FRAME_ERROR));
    if (!new GasTable(results).isEmpty()) {
      measured.add("gas");
    }
    List<String> known = Scenes.all().stream().filter(measured::contains).toList();
    if (known.isEmpty()) {
      return;
    }
    html.append("<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Scenes\">");
    html.append("<table class=\"scenes\">\n<caption>The scenes</caption>\n<thead><tr>");
    for (String name :
        List.of("", "scene", "what it is", "circles", "lines", "walls", "radius", "speed")) {
      html.append("<th scope=\"col\">").append(name).append("</th>");
    }
    html.append("</tr></thead>\n<tbody>\n");
    for (String scene : known) {
      html.append("<tr><td>");
      picture(Thumbnail.of(Parts.scene(scene), "The scene " + scene));
      html.append("<th scope=\"row\">").append(text(scene)).append("</th><td>");
      html.append(text(Scenes.what(scene)));
      Scenes.facts(scene).forEach(cell -> html.append("<td>").append(text(cell)));
      html.append('\n');
    }
    html.append("</tbody></table></div>\n");
  }

  private void methods() {
    Map<String, String> told = new LinkedHashMap<>(Glossary.methods());
    told.keySet().retainAll(results.methods());
    told.forEach(
        (method, what) ->
            item(
                Glossary.name(method),
                what + (method.equals(Glossary.name(method)) ? "" : " (" + method + ")")));
    item("defaults, tuned", "an engine as it comes, and set as well as we could");
  }

  private void accuracy() {
    group("accuracy");
    figure("engines");
    figure("work");
    ReportTable ratios = Ratios.of(results);
    if (!ratios.rows().isEmpty()) {
      html.append("<details><summary>How many times as long as Carom the others take</summary>\n");
      table(ratios, "Times of a frame, Carom = 1: medians, of a heap means", none -> "");
      paragraph(
          "Ratios of median frames; in brackets the least and the greatest that the virtual machines"
              + " allow. Below 1 the other is faster. Of a heap they are ratios of the mean frame, as"
              + " in its chart: most of its frames come after all is at rest, and a median would"
              + " compare those alone.");
      html.append("</details>\n");
    }
    figure("frames");
  }

  private void price() {
    group("price");
    PriceTables price = new PriceTables(results);
    if (!price.questions().rows().isEmpty()) {
      heading(price.questionsTitle());
      paragraph(
          "A question is one circle against one line: whether, and when. Plain doubles are Carom's"
              + " own formulas without their proof. Wrong answers are of %s of each class. "
                  .formatted(asked())
              + price.asGood());
      table(price.questions(), "Time of a question, and wrong answers", Page::factor);
    }
    if (!price.frames().rows().isEmpty()) {
      heading(price.framesTitle());
      paragraph(
          "Two controls share Carom's event loop and kind of grid. They are short programs, not"
              + " tuned as Carom is, so a factor below 1 says that tuning weighs more than"
              + " exactness, not that exactness is free. "
              + price.framesAsGood());
      table(price.frames(), "Median time and worst error of a frame", none -> "");
    }
    QueryFigures questions = new QueryFigures(results);
    folded(questions.sentence(), questions.table(), "Time and error of a question");
    decisions();
  }

  private String asked() {
    double asked =
        results.scenes(Metrics.DECISIONS).stream()
            .flatMap(scene -> results.only(scene, Metrics.CAROM, Metrics.DECISIONS).stream())
            .mapToDouble(Spread::middle)
            .max()
            .orElse(0);
    return ReportNumbers.count(asked);
  }

  private void decisions() {
    DecisionTable decisions = new DecisionTable(results);
    if (!decisions.table().rows().isEmpty()) {
      html.append("<details><summary>")
          .append(text(Verdict.of(results).get(0)))
          .append("</summary>\n");
      table(decisions.table(), "Missed hits | false hits, in exact counts", decisions::heat);
      paragraph("The darker a cell, the larger the share of wrong answers, by decades.");
      html.append("</details>\n");
    }
  }

  /** The more an exact answer costs, the darker. */
  private static String factor(String cell) {
    if (!cell.endsWith(" x")) {
      return "";
    }
    double factor = Double.parseDouble(cell.replace(" x", "").replace(",", ""));
    return factor < 2 ? "" : factor < 5 ? "h1" : factor < 20 ? "h2" : "h3";
  }

  private void needs() {
    group("needs");
    figure("features");
    RungShares rungs = new RungShares(results);
    folded(rungs.sentence(), rungs.table(), "Which precision decided");
  }

  private void stability() {
    group("stability");
    StabilityMatrix matrix = new StabilityMatrix(results);
    if (!matrix.isEmpty()) {
      heading(matrix.title());
      paragraph(
          "Six maps: each of their cells is a small scene, judged against its true course. The table"
              + " has the share of scenes in which no circle was ever more than 0.001 radius off, and the"
              + " share for 0.1 radius. A dark corner marks scenes in which no method can promise to be"
              + " right: their course multiplies the rounding of doubles beyond 0.001 radius, or impacts"
              + " pile up without end.");
      table(matrix.table(), "Share of scenes that are right", Page::share);
      html.append("<div class=\"grid\">\n");
      for (FailureMap map : FailureMap.all(false)) {
        map(map);
      }
      html.append("</div>\n");
    }
    figures.keySet().stream().filter(id -> id.startsWith("drift-")).forEach(this::figure);
    figure("heap");
    figure("bounce");
    figure("trust");
  }

  /** The fewer are right, the darker. */
  private static String share(String cell) {
    if (!cell.contains("%")) {
      return "";
    }
    double right = Double.parseDouble(cell.substring(0, cell.indexOf(' ')));
    return right >= 99 ? "" : right >= 80 ? "h1" : right >= 40 ? "h2" : "h3";
  }

  private void map(FailureMap map) {
    Figure figure = figures.get("fails-" + map.name());
    if (figure == null) {
      return;
    }
    html.append("<section class=\"map\" id=\"").append(text(figure.id())).append("\">\n<h3>");
    html.append(text(figure.title())).append("</h3>\n<div class=\"sketch\">");
    picture(Thumbnail.of(map.example(), "A scene of this map"));
    html.append("<p>").append(text(figure.note())).append("</p></div>\n");
    picture(figure.panels().get(0).picture());
    numbers(figure);
    html.append("</section>\n");
  }

  private void many() {
    group("many");
    GasTable gas = new GasTable(results);
    if (!gas.isEmpty()) {
      heading(gas.title());
      paragraph(
          "A gas of 100 elastic circles in four walls, 600 frames. Its energy should not change, and"
              + " circles should not overlap.");
      table(gas.table(), "A gas of colliding circles", none -> "");
      paragraph(gas.note());
    }
    figure("scale");
    figure("start");
    figure("sweep");
  }

  private void doubts() {
    group("doubts");
    html.append("<ul>\n");
    Doubts.all().forEach(told -> html.append("<li>").append(text(told)).append("</li>\n"));
    html.append("</ul>\n<details><summary>Where Carom is not the best, and what was not asked")
        .append("</summary>\n<ul>\n");
    Shortcomings.of(results)
        .forEach(told -> html.append("<li>").append(text(told)).append("</li>\n"));
    html.append("</ul></details>\n<details><summary>")
        .append(text(AcceptanceLimits.sentence(results)))
        .append("</summary>\n<ul>\n");
    Verdict.of(results).forEach(told -> html.append("<li>").append(text(told)).append("</li>\n"));
    html.append("</ul>\n</details>\n<details><summary>All limits</summary>\n");
    table(AcceptanceLimits.table(results), "Limits, and whether they hold", none -> "");
    AcceptanceLimits.note(results).ifPresent(this::paragraph);
    html.append("</details>\n");
    origin();
  }

  private void heading(String plain) {
    html.append("<h3>").append(text(plain)).append("</h3>\n");
  }

  /** Nothing if there is none of this name. */
  private void figure(String id) {
    Figure figure = figures.get(id);
    if (figure == null) {
      return;
    }
    html.append("<section id=\"").append(text(figure.id())).append("\">\n<h3>");
    html.append(text(figure.title())).append("</h3>\n<p class=\"note\">");
    html.append(text(figure.note())).append("</p>\n");
    html.append("<div class=\"").append(layout(figure)).append("\">\n");
    for (Panel panel : figure.panels()) {
      html.append("<figure>");
      if (!panel.title().isEmpty()) {
        html.append("<figcaption>").append(text(panel.title())).append("</figcaption>");
      }
      picture(panel.picture());
      html.append("</figure>\n");
    }
    html.append("</div>\n");
    numbers(figure);
    html.append("</section>\n");
  }

  /** One or two panels fill the page; more of them stand three in a row. */
  private static String layout(Figure figure) {
    return figure.panels().size() < 3 ? "grid large" : "grid";
  }

  /** A table that a sentence opens; nothing if it is empty. */
  private void folded(String sentence, ReportTable table, String label) {
    if (!table.rows().isEmpty()) {
      html.append("<details><summary>").append(text(sentence)).append("</summary>\n");
      table(table, label, none -> "");
      html.append("</details>\n");
    }
  }

  private void numbers(Figure figure) {
    html.append("<details><summary>In words, and the numbers</summary>\n");
    paragraph(figure.caption());
    table(figure.table(), figure.heading(), none -> "");
    html.append("</details>\n");
  }

  /** Writes a picture. Its label is short, for words beside the picture say the rest. */
  private void picture(Picture picture) {
    String prefix = "p" + pictures++ + "-";
    String label = "<svg role=\"img\" aria-label=\"" + text(picture.title()) + "\" ";
    html.append("<div class=\"picture\">");
    html.append(slim(classed(themed(picture.svg(prefix)))).replaceFirst("<svg ", quoted(label)));
    html.append("</div>\n");
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

  private static String quoted(String replacement) {
    return Matcher.quoteReplacement(replacement);
  }

  /** Writes styles shared by thousands of marks once. They are a third of the page. */
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
    styles.forEach((style, index) -> html.append(".s" + index + "{" + style + "}\n"));
    html.append("</style>\n");
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

  /** Classes of cells follow from their texts. */
  private void table(ReportTable table, String label, UnaryOperator<String> cellClass) {
    html.append("<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"")
        .append(text(label))
        .append(": numbers\"><table>\n<caption>")
        .append(text(label))
        .append("</caption>\n<thead><tr>");
    table
        .head()
        .forEach(cell -> html.append("<th scope=\"col\">").append(text(cell)).append("</th>"));
    html.append("</tr></thead>\n<tbody>\n");
    for (List<String> row : table.rows()) {
      html.append("<tr><th scope=\"row\">").append(text(row.get(0)));
      // HTML lets cells and rows end where the next one begins: that is a 50th of the page.
      row.stream()
          .skip(1)
          .forEach(
              cell -> {
                String name = cellClass.apply(cell);
                html.append(name.isEmpty() ? "<td>" : "<td class=\"" + name + "\">");
                html.append(text(cell));
              });
      html.append('\n');
    }
    html.append("</tbody></table></div>\n");
  }

  private void origin() {
    Metadata m = results.metadata();
    html.append("<details><summary>Where these numbers come from</summary>\n<dl>\n");
    item("processor", m.cpu() + ", " + m.cores() + " cores");
    item("system", m.os());
    item("virtual machine", (m.jdk() + " " + m.flags()).strip());
    item("commit", m.commit());
    m.scenes()
        .forEach(
            (scene, hash) ->
                item(
                    "scene " + scene,
                    "src/test/resources/scenes/%s.csv, SHA-256 %s".formatted(scene, hash)));
    m.seeds().forEach((name, seed) -> item("seed " + name, Long.toString(seed)));
    item("rows", ReportNumbers.count(results.rows().size()));
    failures().forEach(failure -> item("not measured", failure));
    html.append("</dl></details>\n");
  }

  /** The failures: which method, where and why, each once. */
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
