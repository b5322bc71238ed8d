// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import java.util.List;

/** The first screen of the report as a page that a repository shows by itself. */
final class ResultsReadme {

  /** The figures that stand in it, if they were made. */
  private static final List<String> PICTURES =
      List.of("engines", "heap", "work", "features", "fails-angle");

  /** Methods whose names do not say what they are. */
  private static final List<String> NAMED = List.of("poster", "plain-grid");

  private final Results results;
  private final List<Figure> figures;
  private final StringBuilder text = new StringBuilder();

  private ResultsReadme(Results results, List<Figure> figures) {
    this.results = results;
    this.figures = figures;
  }

  static String of(Results results, List<Figure> figures) {
    ResultsReadme readme = new ResultsReadme(results, figures);
    readme.first();
    readme.pictures();
    readme.links();
    return readme.text.toString();
  }

  private void first() {
    FirstScreen screen = new FirstScreen(results);
    text.append("# Speed and accuracy\n\n").append(screen.sentence()).append("\n\n");
    if (!screen.tiles().isEmpty()) {
      text.append("| | Carom | others |\n| --- | --- | --- |\n");
      for (FirstScreen.Tile tile : screen.tiles()) {
        text.append("| ").append(tile.name()).append(" | **").append(tile.value());
        text.append("** ").append(tile.what()).append(" | ").append(tile.rival()).append(" |\n");
      }
      text.append('\n');
      text.append(
          "Each frame starts from the true state, computed to more digits than a double holds; its"
              + " error is in radii of the circle. The circles ignore each other.");
      NAMED.stream()
          .filter(results.methods()::contains)
          .forEach(
              method ->
                  text.append(" \"%s\" is %s.".formatted(Glossary.name(method), what(method))));
      text.append("\n\n");
    }
    picture("work-" + screen.scene());
  }

  private static String what(String method) {
    return Glossary.methods().get(method);
  }

  private void pictures() {
    PriceTables price = new PriceTables(results);
    if (!price.questions().rows().isEmpty()) {
      text.append(price.questionsTitle()).append(". ").append(price.asGood()).append("\n\n");
    }
    PICTURES.forEach(this::picture);
  }

  private void picture(String id) {
    figures.stream()
        .filter(figure -> figure.id().equals(id))
        .forEach(
            figure ->
                text.append("![")
                    .append(figure.title())
                    .append("](")
                    .append(id)
                    .append(".png)\n\n"));
  }

  private void links() {
    Metadata m = results.metadata();
    text.append(m.quick() ? "A short run of " : "A run of ")
        .append(
            "%s on %s, %d cores, %s, commit %s. "
                .formatted(m.date(), m.cpu(), m.cores(), m.jdk(), m.commit()))
        .append("All numbers are in [results.json.gz](results.json.gz). The whole page, with every")
        .append(" chart, its numbers, and how to read them, is made from them in seconds:\n\n")
        .append("```sh\nmvn -q -DskipTests package\n")
        .append("java -jar bench/target/carom-bench.jar report --from bench/results --out report\n")
        .append("```\n\nIt is then `report/report.html`.\n");
  }
}
