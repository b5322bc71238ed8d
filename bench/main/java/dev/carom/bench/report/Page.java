// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Panel;
import dev.carom.bench.charts.Thumbnail;
import dev.carom.bench.measures.Parts;
import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.FailureMap;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The report as one page: a template whose slots are filled from the results. It needs no network,
 * and its colours follow the reader's choice of light or dark.
 */
final class Page {

  private final InlineSvg pictures = new InlineSvg();
  private final Results results;
  private final List<Figure> figures;

  private Page(Results results, List<Figure> figures) {
    this.results = results;
    this.figures = figures;
  }

  static String of(Results results, List<Figure> figures) {
    return Texts.fill("page.html", new Page(results, figures)::filled);
  }

  private String filled(String slot, String ids) {
    return switch (slot) {
      case "css" -> Texts.read("report.css");
      case "sentence" -> text(new FirstScreen(results).sentence());
      case "tiles" -> joined(new FirstScreen(results).tiles().stream().map(Page::tile));
      case "figures" -> joined(Figure.named(ids, figures).map(this::figure));
      case "scenes" -> scenes();
      case "methods" -> methods();
      case "run" -> run();
      case "quick" -> results.metadata().quick() ? " --quick" : "";
      case "shortcomings" -> items(Verdict.shortcomings(results));
      case "limits" -> text(AcceptanceLimits.sentence(results));
      case "verdict" -> items(Verdict.of(results));
      case "all-limits" -> table(AcceptanceLimits.table(results), "Limits, and whether they hold");
      case "failures" -> items(failures());
      case "styles" -> pictures.styles();
      default -> throw new IllegalStateException("the page has a slot " + slot);
    };
  }

  private static String joined(Stream<String> parts) {
    return parts.collect(Collectors.joining("\n"));
  }

  private static String items(List<String> sentences) {
    return joined(sentences.stream().map(told -> "<li>" + text(told) + "</li>"));
  }

  private static String tile(FirstScreen.Tile tile) {
    return "<div class=\"tile\"><b>%s</b><span class=\"value\">%s</span><span>%s</span><span class=\"quiet\">%s</span></div>"
        .formatted(text(tile.name()), text(tile.value()), text(tile.what()), text(tile.rival()));
  }

  private String figure(Figure figure) {
    if (figure.id().startsWith(StabilityFigures.PREFIX)) {
      return map(figure);
    }
    return section(figure, "<p class=\"note\">" + text(figure.note()) + "</p>\n" + panels(figure));
  }

  private String section(Figure figure, String body) {
    return "<section id=\"%s\">\n<h3>%s</h3>\n%s%s</section>\n"
        .formatted(figure.id(), text(figure.title()), body, numbers(figure));
  }

  private String panels(Figure figure) {
    // One or two panels fill the page; more of them stand three in a row.
    String layout = figure.panels().size() < 3 ? "grid large" : "grid";
    return figure.panels().stream()
        .map(this::panel)
        .collect(Collectors.joining("", "<div class=\"" + layout + "\">\n", "</div>\n"));
  }

  private String panel(Panel panel) {
    String caption =
        panel.title().isEmpty() ? "" : "<figcaption>" + text(panel.title()) + "</figcaption>";
    return "<figure>" + caption + pictures.of(panel.picture()) + "</figure>\n";
  }

  /** A scene of the map stands beside the words. */
  private String map(Figure figure) {
    String name = figure.id().substring(StabilityFigures.PREFIX.length());
    FailureMap map =
        FailureMap.all(false).stream().filter(m -> m.name().equals(name)).findFirst().orElseThrow();
    String sketch = pictures.of(Thumbnail.of(map.example(), "A scene of this map"));
    return section(
        figure,
        "<div class=\"sketch\">%s<p>%s</p></div>\n%s"
            .formatted(sketch, text(figure.note()), pictures.of(figure.panels().get(0).picture())));
  }

  /** The table: behind pictures folded. */
  private static String numbers(Figure figure) {
    if (figure.table().isEmpty()) {
      return "";
    }
    String table = table(figure.table(), figure.heading());
    return figure.panels().isEmpty()
        ? table
        : "<details><summary>The numbers</summary>\n" + table + "</details>\n";
  }

  private static String table(ReportTable table, String label) {
    return table(label, "", table.head(), table.rows().stream().map(Page::row));
  }

  private static String table(
      String label, String attributes, List<String> head, Stream<String> rows) {
    String titles =
        head.stream()
            .map(cell -> "<th scope=\"col\">" + text(cell) + "</th>")
            .collect(Collectors.joining());
    return """
    <div class="scroll" tabindex="0" role="group" aria-label="%s: numbers"><table%s>
    <caption>%s</caption>
    <thead><tr>%s</tr></thead>
    <tbody>
    %s
    </tbody></table></div>
    """
        .formatted(text(label), attributes, text(label), titles, joined(rows));
  }

  /** HTML lets cells and rows end where the next one begins: that is a 50th of the page. */
  private static String row(List<String> cells) {
    return cells.stream()
        .skip(1)
        .map(Page::cell)
        .collect(Collectors.joining("", "<tr><th scope=\"row\">" + text(cells.get(0)), ""));
  }

  private static String cell(String text) {
    String shade = shade(text);
    return (shade.isEmpty() ? "<td>" : "<td class=\"" + shade + "\">") + text(text);
  }

  /** The more an exact answer costs, and the fewer scenes are right, the darker. */
  private static String shade(String cell) {
    if (cell.endsWith(Figure.TIMES)) {
      double factor = Double.parseDouble(cell.replace(Figure.TIMES, "").replace(",", ""));
      return shade(factor >= 2, factor >= 5, factor >= 20);
    }
    if (cell.contains(MapTally.BAR)) {
      double right = Double.parseDouble(cell.substring(0, cell.indexOf(' ')));
      return shade(right < 99, right < 80, right < 40);
    }
    return "";
  }

  private static String shade(boolean light, boolean darker, boolean darkest) {
    if (darkest) {
      return "h3";
    }
    return darker ? "h2" : light ? "h1" : "";
  }

  private String scenes() {
    return table(
        "The scenes",
        " class=\"scenes\"",
        List.of("", "scene", "what it is", "what it has", "in px and px a frame"),
        Scenes.all().keySet().stream()
            .filter(scene -> !Standing.all(results, scene).isEmpty())
            .map(this::scene));
  }

  private String scene(String name) {
    String picture = pictures.of(Thumbnail.of(Parts.scene(name), "The scene " + name));
    return Scenes.all().get(name).stream()
        .map(Page::cell)
        .collect(
            Collectors.joining(
                "", "<tr><td>" + picture + "<th scope=\"row\">" + text(name) + "</th>", ""));
  }

  private String methods() {
    return joined(
        Glossary.methods().stream()
            .filter(results.methods()::contains)
            .map(
                method ->
                    item(Glossary.name(method), Glossary.what(method) + " (" + method + ")")));
  }

  private String run() {
    Metadata m = results.metadata();
    return text(
        "%s of %s on %s, %d cores, %s; %s; commit %s%s"
            .formatted(
                m.quick() ? "A short run" : "Run",
                m.date(),
                m.cpu(),
                m.cores(),
                m.os(),
                (m.jdk() + " " + m.flags()).strip(),
                m.commit().substring(0, Math.min(12, m.commit().length())),
                Origin.age(m.commit())));
  }

  /** What broke down or could not be played, and why: each once. */
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

  private static String item(String name, String value) {
    return "<dt>" + text(name) + "</dt><dd>" + text(value) + "</dd>";
  }

  static String text(String plain) {
    return plain
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
