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
      List.of("work-base-1", "engines", "work", "drift-base-1", "frames", "sweep");

  @TempDir static Path dir;
  private static Results stored;
  private static String page;

  @BeforeAll
  static void write() throws IOException, URISyntaxException {
    stored = ResultsJson.read(Path.of(ReportTest.class.getResource("results.json").toURI()));
    Report.write(stored, dir);
    page = Files.readString(dir.resolve(Report.PAGE));
  }

  @Test
  void everyFigureIsAPictureAndASection() throws IOException {
    for (String figure : FIGURES) {
      assertThat(ImageIO.read(dir.resolve(figure + ".png").toFile()).getWidth())
          .isBetween(800, 2000);
      assertThat(dir.resolve(figure + ".svg")).isNotEmptyFile();
      assertThat(page).containsOnlyOnce("<section id=\"" + figure + "\">");
    }
    try (Stream<Path> files = Files.list(dir)) {
      assertThat(files).hasSize(2 * FIGURES.size() + 5);
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

  /** In ten seconds: what it is, three numbers, and the chart; then seven groups at most. */
  @Test
  void theFirstScreenHasASentenceThreeTilesAndTheChart() {
    String first = page.substring(0, page.indexOf("<h2"));
    assertThat(first)
        .contains(
            "<h1>Exact, and the fastest measured: the median frame of 100 circles among 100 lines"
                + " takes 1.04 µs; the nearest that is as accurate (exact) takes 1.6 times as long; Box2D takes 40 times"
                + " as long and errs by up to 0.2 radii.</h1>")
        .contains("<span class=\"value\">1.04 µs</span><span>a frame, median</span>")
        .contains("<span class=\"quiet\">Box2D: 41.6 µs; published 2010: 68.6 µs</span>")
        .contains("<section id=\"work-base-1\">");
    assertThat(first.split("<a href=\"#", -1)).hasSizeBetween(3, 8);
    Pattern.compile("<a href=\"#([^\"]*)\"")
        .matcher(first)
        .results()
        .forEach(link -> assertThat(page).contains("id=\"" + link.group(1) + "\""));
  }

  @Test
  void everyPictureHasAnAlternativeAndItsNumbersAreBehindIt() {
    assertThat(page.split("<svg ", -1).length)
        .isEqualTo(page.split("<svg role=\"img\" aria-label=\"[^\"]{10,}\"", -1).length);
    for (String figure : List.of("work-base-1", "work", "drift-base-1")) {
      String section = page.substring(page.indexOf("<section id=\"" + figure + "\">"));
      assertThat(section.substring(0, section.indexOf("</section>")))
          .contains("<details><summary>The numbers</summary>", "<table>");
    }
  }

  @Test
  void tablesHaveCaptionsAndScopes() {
    int tables = page.split("<table", -1).length;
    assertThat(page.split("<caption>[^<]+</caption>", -1)).hasSize(tables);
    assertThat(page).doesNotContain("<th>").contains("<th scope=\"col\">", "<th scope=\"row\">");
    assertThat(page).contains("<a class=\"skip\" href=\"#read\">");
  }

  @Test
  void theScenesAreToldWithTheirSizes() {
    assertThat(page)
        .containsPattern(
            "base-1</th><td>the published experiment<td>100 circles among 100 lines<td>radius 10, speed")
        .contains("aria-label=\"The scene fast-1\"");
  }

  @Test
  void theReadmeHasTheSentenceTheTilesAndPictures() throws IOException {
    assertThat(dir.resolve("README.md"))
        .content()
        .contains("Exact, and the fastest measured: the median frame of", "| Speed |", "1.04 µs")
        .contains("\"published 2010\" is the published algorithm of 2010")
        .contains("](work-base-1.png)", "results.json.gz");
  }

  @Test
  void stylesAreWrittenOnce() {
    assertThat(page).contains("class='s0'", "\n.s0{").doesNotContain("style='");
  }

  @Test
  void thePageHasTheVerdictAndTheRatios() {
    assertThat(page)
        .contains("<li>Decisions: wrong answers of Carom: 0 of 30,000")
        .containsPattern("published 2010<td>base-1<td>68.6 µs [^<]*<td>66 \\(61.6 .. 70.7\\)<td>")
        .contains("<dt>published 2010</dt><dd>the published algorithm of 2010, in float")
        .contains("slowest frame<td>base-1<td>16.7 ms<td>")
        .contains("; commit 0123456789ab");
  }

  @Test
  void theVerdictIsStoredAsTextWithItsLimits() throws IOException {
    List<String> lines = Files.readAllLines(dir.resolve("verdict.txt"));
    assertThat(lines.subList(0, 6)).isEqualTo(Verdict.of(stored));
    assertThat(lines)
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
    assertThat(empty.resolve(Report.PAGE)).content().contains("<h1>Not measured.</h1>", "</html>");
  }

  @Test
  void theStoredDataSetIsTheSample() {
    assertThat(stored.rows()).isEqualTo(Sample.complete().results().rows());
  }
}
