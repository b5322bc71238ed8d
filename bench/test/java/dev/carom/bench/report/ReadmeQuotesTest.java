// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsJson;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What READMEs quote of the report is what the committed results say: stale numbers fail. */
class ReadmeQuotesTest {

  private static final Path ROOT = Path.of("..");
  private static final String VERDICT = "(Decisions|Accuracy|Budget|Place|Growth|Limits): .*";

  @BeforeAll
  static void headless() {
    System.setProperty("java.awt.headless", "true");
  }

  @Test
  void theVerdictIsThatOfTheCommittedResults() throws IOException {
    Path results = ROOT.resolve("bench/results").resolve(Report.RESULTS);
    List<String> made =
        Verdict.of(ResultsJson.read(results)).stream()
            .filter(sentence -> !sentence.endsWith("not measured."))
            .toList();
    try (Stream<String> lines = Files.lines(ROOT.resolve("README.md"))) {
      assertThat(lines.filter(line -> line.matches(VERDICT)).toList()).isEqualTo(made);
    }
  }

  @Test
  void thePageOfTheResultsIsThatOfTheCommittedResults() throws IOException {
    Path folder = ROOT.resolve("bench/results");
    Results results = ResultsJson.read(folder.resolve(Report.RESULTS));
    String made = ResultsReadme.of(results, Report.figures(results));
    assertThat(folder.resolve(Report.README)).hasContent(made);
    Pattern.compile("]\\(([^):]+)\\)")
        .matcher(made)
        .results()
        .forEach(link -> assertThat(folder.resolve(link.group(1))).exists());
  }
}
