// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.bench.results.ResultsJson;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReadmeFiguresTest {

  private static final Path ROOT = Path.of("..");

  @ParameterizedTest
  @CsvSource({"README.md, 20", "bench/README.md, 2"})
  void thePagesQuoteTheCommittedResults(String name, int marks) throws IOException {
    String page = Files.readString(ROOT.resolve(name));

    String filled =
        ReadmeFigures.fill(
            page, ResultsJson.read(ROOT.resolve("bench/results").resolve(Report.RESULTS)));

    assertThat(page)
        .as("write it anew with: report --from bench/results --readme %s", name)
        .isEqualTo(filled);
    assertThat(page.split("<!--")).hasSizeGreaterThan(marks);
    assertThat(page.lines())
        .as(
            "a comment at the start of a line ends the paragraph: a mark there has a line of its own")
        .noneMatch(line -> line.strip().matches("<!--.+-->.*") && !line.matches("<!--[^>]+-->"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "time:poster     | 68.6 µs",
        "ratio:poster    | 66",
        "spread:poster   | 62 to 71",
        "impacts:carom   | 4.35",
        "time:dyn4j      | 343 µs",
        "error:dyn4j     | 0.03",
        "published       | 760",
        "wrong           | 0 of 30,000",
        "machine         | a processor, 2 cores; a jdk",
        "commit          | 0123456789",
        "date            | 2026-01-02"
      })
  void eachFigureIsThatOfTheResults(String name, String figure) {
    Sample sample = Sample.complete();
    sample.add("base-1", "poster", "", "frame_time", "mean", 68_530, "ns", 0);
    sample.add("base-1", "carom", "", "impacts", "mean", 3.02, "1", -1);
    sample.add("base-1", "carom", "", "wall_impacts", "mean", 1.33, "1", -1);
    String mark = "one <!--" + name + "-->%s<!--/" + name + "-->, and more";

    assertThat(ReadmeFigures.fill(mark.formatted("two\n* <b>three</b>"), sample.results()))
        .isEqualTo(mark.formatted(figure));
  }

  @Test
  void theVerdictIsABlock() {
    assertThat(
            ReadmeFigures.fill(
                "<!--verdict-->\n```\nold\n```\n<!--/verdict-->\n", Sample.complete().results()))
        .startsWith("<!--verdict-->\n```\nDecisions: wrong answers of Carom: 0 of 30,000")
        .endsWith(".\n```\n<!--/verdict-->\n");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<!--speed-->1<!--/speed-->   | no figure \"speed\": expected time, ratio",
        "<!--time:x-->1<!--/time:x--> | frame_time of \"x\" in base-1: not measured",
        "<!--date-->1                   | the mark <!--date--> stands alone: expected one",
        "<!--date-->1<!--/commit-->   | the mark <!--date--> stands alone",
        "1<!--/date-->                  | the mark <!--/date--> stands alone"
      })
  void wrongMarksAreRefused(String text, String message, @TempDir Path folder) throws IOException {
    Path page = Files.writeString(folder.resolve("page.md"), text);

    assertThatThrownBy(() -> ReadmeFigures.write(page, Sample.complete().results()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith(page + ": ")
        .hasMessageContaining(message);
    assertThat(page).hasContent(text);
  }
}
