// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.ResultsJson;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The report made from a stored data set. */
class ReportTest {

  private static final List<String> FIGURES =
      List.of(
          "work-base-1",
          "tests-base-1",
          "work-fast-1",
          "tests-fast-1",
          "queries",
          "decisions",
          "drift-base-1",
          "frames-base-1",
          "sweep");

  @TempDir static Path dir;
  private static Results stored;
  private static String page;

  @BeforeAll
  static void write() throws IOException, URISyntaxException {
    System.setProperty("java.awt.headless", "true");
    stored = ResultsJson.read(Path.of(ReportTest.class.getResource("results.json").toURI()));
    Report.write(stored, dir);
    page = Files.readString(dir.resolve(Report.PAGE));
  }

  @Test
  void everyFigureIsAPictureAndASection() throws IOException {
    for (String figure : FIGURES) {
      assertThat(ImageIO.read(dir.resolve(figure + ".png").toFile()).getWidth()).isEqualTo(1800);
      assertThat(dir.resolve(figure + ".svg")).isNotEmptyFile();
      assertThat(page).contains("<section id=\"" + figure + "\">", "href=\"#" + figure + "\"");
    }
    try (Stream<Path> files = Files.list(dir)) {
      assertThat(files).hasSize(2 * FIGURES.size() + 4);
    }
  }

  @Test
  void theResultsAreStoredWithIt() throws IOException {
    assertThat(ResultsJson.read(dir.resolve(Report.RESULTS)).rows()).isEqualTo(stored.rows());
    assertThat(ResultsCsv.read(dir.resolve("results.csv")))
        .isEqualTo(
            stored.rows().stream().filter(row -> !row.metric().equals("frame_raw")).toList());
  }

  @Test
  void theSameResultsGiveTheSameFiles() throws IOException {
    Path again = Files.createDirectory(dir.resolveSibling(dir.getFileName() + "-again"));
    Report.write(ResultsJson.read(dir.resolve(Report.RESULTS)), again);
    try (Stream<Path> files = Files.list(dir)) {
      assertThat(files)
          .allSatisfy(
              file -> assertThat(again.resolve(file.getFileName())).hasSameBinaryContentAs(file));
    }
  }

  @Test
  void thePageNeedsNothingElse() {
    assertThat(page)
        .doesNotContain("<script", "<link", "@import", "url(\"http", "src=")
        .doesNotContain("rgb(250,249,245)")
        .contains("prefers-color-scheme: dark", "fill:var(--paper)");
  }

  @Test
  void everyPictureHasAnAlternativeAndATable() {
    assertThat(page.split("<svg role=\"img\" aria-label=\"[^\"]{40,}\"", -1))
        .hasSize(1 + 2 * FIGURES.size()); // one for narrow screens
    assertThat(page.split("<details>", -1)).hasSize(1 + FIGURES.size());
  }

  @Test
  void everyPictureHasACaptionOfOneSentence() {
    List<String> captions =
        Pattern.compile("<figcaption>([^<]*)</figcaption>")
            .matcher(page)
            .results()
            .map(match -> match.group(1))
            .toList();
    assertThat(captions).hasSize(FIGURES.size()).allMatch(text -> text.endsWith("."));
    assertThat(captions).noneMatch(text -> text.contains(". "));
  }

  @Test
  void stylesAreWrittenOnce() {
    assertThat(page).contains("class='s0'", "\n.s0{").doesNotContain("style='");
  }

  @Test
  void thePageHasTheVerdictAndTheRatios() {
    assertThat(page)
        .contains("<b>Decisions</b>Wrong answers of carom: 0 of 30,000")
        .contains("<td>poster<td>66 (61.6 .. 70.7)<td>")
        .contains("<dt>poster</dt><dd>the published algorithm")
        .contains("<td>slowest frame<td>base-1<td>16.7 ms<td>")
        .contains("<li>In base-1 half of carom's circles have left the true course by frame 230;")
        .contains("commit</dt><dd>0123456789abcdef");
  }

  @Test
  void theVerdictIsStoredAsTextWithItsRatiosAndLimits() throws IOException {
    List<String> lines = Files.readAllLines(dir.resolve("verdict.txt"));
    assertThat(lines.subList(0, 6)).isEqualTo(Verdict.of(stored));
    assertThat(lines)
        .anyMatch(line -> line.matches("poster +66 \\(61.6 .. 70.7\\) +66 \\(61.6 .. 70.7\\)"))
        .anyMatch(line -> line.matches("slowest frame +base-1 +16.7 ms +3.12 µs +yes"));
  }

  @Test
  void idsOfInlinePicturesDoNotClash() {
    List<String> ids =
        Pattern.compile("\\bid='([^']+)'")
            .matcher(page)
            .results()
            .map(match -> match.group(1))
            .filter(id -> !id.equals("picture"))
            .toList();
    assertThat(ids).isNotEmpty().doesNotHaveDuplicates();
  }

  @Test
  void aReportOfNothingIsAPage() throws IOException {
    Path empty = dir.resolveSibling(dir.getFileName() + "-empty");
    Report.write(new Results(Sample.METADATA, List.of()), empty);
    assertThat(empty.resolve(Report.PAGE)).content().contains("Not measured.", "</html>");
  }

  @Test
  void theStoredDataSetIsTheSample() {
    assertThat(stored.rows()).isEqualTo(Sample.complete().results().rows());
  }
}
