// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import java.util.List;
import java.util.stream.Collectors;

/** The first screen of the report as a page that a repository shows by itself. */
final class ResultsReadme {

  private final Results results;
  private final List<Figure> figures;

  private ResultsReadme(Results results, List<Figure> figures) {
    this.results = results;
    this.figures = figures;
  }

  static String of(Results results, List<Figure> figures) {
    return Texts.fill("results.md", new ResultsReadme(results, figures)::filled);
  }

  private String filled(String slot, String words) {
    return switch (slot) {
      case "sentence" -> new FirstScreen(results).sentence();
      case "tiles" -> tiles();
      case "method" -> Glossary.what(words);
      case "figures" ->
          Figure.named(words, figures)
              .map(figure -> "![%s](%s.png)".formatted(figure.title(), figure.id()))
              .collect(Collectors.joining("\n\n"));
      case "questions" -> questions();
      case "run" -> run();
      default -> throw new IllegalStateException("the page has a slot " + slot);
    };
  }

  private String tiles() {
    return new FirstScreen(results)
        .tiles().stream()
            .map(
                tile ->
                    "| %s | **%s** %s | %s |"
                        .formatted(tile.name(), tile.value(), tile.what(), tile.rival()))
            .collect(Collectors.joining("\n"));
  }

  private String questions() {
    return Figure.named("questions", figures)
        .map(figure -> figure.title() + ". " + new QuestionFigures(results).asGood())
        .collect(Collectors.joining());
  }

  private String run() {
    Metadata m = results.metadata();
    return "%s on %s, %d cores, %s, commit %s"
        .formatted(m.date(), m.cpu(), m.cores(), m.jdk(), m.commit());
  }
}
