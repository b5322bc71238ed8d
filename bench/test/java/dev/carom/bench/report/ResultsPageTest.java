// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsJson;
import java.io.IOException;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The page beside the stored results is what they say: stale numbers fail. */
class ResultsPageTest {

  private static final Path ROOT = Path.of("..");

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
