// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The first screen of the report as a page that a repository shows by itself. */
final class ResultsReadme {

  /** The figures that stand in it below the first, if they were made. */
  private static final List<String> PICTURES =
      List.of("engines", "heap", "work", "features", "fails-angle");

  /** Methods whose names do not say what they are. */
  private static final List<String> NAMED = List.of(FirstScreen.PUBLISHED, "plain-grid");

  private final Results results;
  private final List<Figure> figures;
  private final FirstScreen screen;

  private ResultsReadme(Results results, List<Figure> figures) {
    this.results = results;
    this.figures = figures;
    screen = new FirstScreen(results);
  }

  static String of(Results results, List<Figure> figures) {
    ResultsReadme readme = new ResultsReadme(results, figures);
    return Stream.of(
            "# Speed and accuracy",
            readme.screen.sentence(),
            readme.tiles(),
            readme.explained(),
            readme.pictures(List.of("work-" + readme.screen.scene())),
            readme.questions(),
            readme.pictures(PICTURES),
            readme.origin())
        .filter(part -> !part.isEmpty())
        .collect(Collectors.joining("\n\n"));
  }

  private String tiles() {
    List<FirstScreen.Tile> tiles = screen.tiles();
    return tiles.isEmpty()
        ? ""
        : tiles.stream()
            .map(ResultsReadme::row)
            .collect(Collectors.joining("\n", "| | Carom | others |\n| --- | --- | --- |\n", ""));
  }

  private static String row(FirstScreen.Tile tile) {
    return "| %s | **%s** %s | %s |"
        .formatted(tile.name(), tile.value(), tile.what(), tile.rival());
  }

  private String explained() {
    return NAMED.stream()
        .filter(results.methods()::contains)
        .map(m -> " \"%s\" is %s.".formatted(Glossary.name(m), Glossary.what(m)))
        .collect(
            Collectors.joining(
                "",
                "Each frame starts from the true state, computed to more digits than a double holds; its error is in radii of the circle. The circles ignore each other.",
                ""));
  }

  private String questions() {
    QuestionFigures questions = new QuestionFigures(results);
    return questions.figures().isEmpty() ? "" : questions.title() + ". " + questions.asGood();
  }

  private String pictures(List<String> ids) {
    return ids.stream()
        .flatMap(id -> figures.stream().filter(figure -> figure.id().equals(id)))
        .map(figure -> "![%s](%s.png)".formatted(figure.title(), figure.id()))
        .collect(Collectors.joining("\n\n"));
  }

  private String origin() {
    Metadata m = results.metadata();
    return """
    %s of %s on %s, %d cores, %s, commit %s. All numbers are in [results.json.gz](results.json.gz). The whole page, with every chart, its numbers, and how to read them, is made from them in seconds:

    ```sh
    mvn -q -DskipTests package
    java -jar bench/target/carom-bench.jar report --from bench/results --out report
    ```

    It is then `report/report.html`.
    """
        .formatted(
            m.quick() ? "A short run" : "A run", m.date(), m.cpu(), m.cores(), m.jdk(), m.commit());
  }
}
