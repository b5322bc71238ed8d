// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ResultsFilesTest {

  private static final Metadata METADATA =
      new Metadata(
          "a \"processor\"",
          2,
          "an os",
          "a jdk",
          "",
          "unknown",
          Map.of("base-1", "00ff"),
          Map.of("sweep", 1L),
          "2026-01-02",
          true);

  private static Row row(String stat, double value, int fork) {
    return new Row("base-1", "a, b\n\"c\"", "k=1", "frame_time", stat, value, "ns", 600, fork);
  }

  private static final List<Row> ROWS =
      List.of(
          row("mean", 0.1, 0),
          row("p5", Double.NaN, 0),
          row("worst", Double.POSITIVE_INFINITY, 0),
          row("mean", -0.0, 0),
          row("mean", Double.NEGATIVE_INFINITY, 1),
          row("p5", Double.MIN_VALUE, 1),
          row("worst", 2.0E-3, -1),
          row("median", Double.MAX_VALUE, -1));

  @TempDir Path folder;

  @Test
  void jsonGivesEveryBitBack() throws IOException {
    Path file = folder.resolve("results.json");
    ResultsJson.write(new Results(METADATA, ROWS), file);
    Results read = ResultsJson.read(file);
    assertThat(read.metadata()).isEqualTo(METADATA);
    assertThat(read.rows()).isEqualTo(ROWS);
    assertThat(Files.readString(file)).hasLineCount(6);
  }

  @Test
  void csvGivesEveryBitBack() throws IOException {
    Path file = folder.resolve("results.csv");
    ResultsCsv.write(ROWS, file);
    assertThat(ResultsCsv.read(file)).isEqualTo(ROWS);
    assertThat(Files.readString(file))
        .startsWith("scene,method,knob,metric,stat,value,unit,n,fork\nbase-1,\"a, b");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0.1         | x       | :3:",
        "0.1         | null    | rows[0] has no value",
        "600         | 6.5     | rows[0].n: ",
        "600         | null    | rows[0].n: ",
        "`ns`        | null    | rows[0]",
        "0.1,        | 0.1     | :3:",
        "`fork`      | `fark`  | rows[0].fork: Missing",
        "]}          | ]       | :7:",
        "`version`:1 | `version`:2 | version is 2: expected 1"
      })
  void corruptJsonIsRefused(String from, String to, String message) throws IOException {
    Path file = folder.resolve("results.json");
    ResultsJson.write(new Results(METADATA, ROWS), file);
    String text = Files.readString(file);
    String corrupt = text.replaceFirst(quoted(from), to.replace('`', '"'));
    assertThat(corrupt).isNotEqualTo(text);
    Files.writeString(file, corrupt);

    assertThatIOException()
        .isThrownBy(() -> ResultsJson.read(file))
        .withMessageStartingWith(file.toString())
        .withMessageContaining(message);
  }

  @Test
  void aPackedFileIsReadWhereThePlainOneIsNotThere() throws IOException {
    Path file = folder.resolve("results.json");
    Results results = new Results(METADATA, ROWS);
    ResultsJson.write(results, file);
    byte[] plain = Files.readAllBytes(file);
    try (var out = new GZIPOutputStream(Files.newOutputStream(folder.resolve("results.json.gz")))) {
      out.write(plain);
    }
    Files.delete(file);
    assertThat(ResultsJson.read(file).rows()).isEqualTo(ROWS);
    ResultsJson.write(new Results(METADATA, ROWS.subList(0, 1)), file);
    assertThat(ResultsJson.read(file).rows()).hasSize(1);
  }

  private static String quoted(String text) {
    return Pattern.quote(text.replace('`', '"'));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "b,m,,x,s,1.O,ns,1,0  | :3: value is \"1.O\": expected a number",
        "b,m,,x,s,1.0,ns,1.5,0| :3: n is \"1.5\": expected a whole number from -1",
        "b,m,,x,s,1.0,ns,1,-2 | :3: fork is \"-2\": expected a whole number from -1",
        "b,m,,x,s,1.0,ns,1    | :3: 8 cells: expected 9",
        "\"b,m,,x,s,1.0       | results.csv: "
      })
  void corruptCsvIsRefused(String line, String message) throws IOException {
    Path file = folder.resolve("results.csv");
    String head = "scene,method,knob,metric,stat,value,unit,n,fork\n";
    Files.writeString(file, head + "b,m,,x,s,NaN,ns,1,0\n" + line + "\n");
    assertThatIOException()
        .isThrownBy(() -> ResultsCsv.read(file))
        .withMessageStartingWith(file.toString())
        .withMessageContaining(message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {"'' | empty", "a,b | a,b: expected scene,method"})
  void whatIsNoTableIsRefused(String text, String message) throws IOException {
    Path file = Files.writeString(folder.resolve("results.csv"), text);
    assertThatIOException()
        .isThrownBy(() -> ResultsCsv.read(file))
        .withMessageStartingWith(file + ":1: " + message);
  }

  @Test
  void onlyTheDateMayDiffer() {
    assertThat(METADATA.matches(changed("unknown", "2027-01-01"))).isTrue();
    assertThat(METADATA.matches(changed("abc", "2026-01-02"))).isFalse();
  }

  private static Metadata changed(String commit, String date) {
    Metadata m = METADATA;
    return new Metadata(
        m.cpu(), m.cores(), m.os(), m.jdk(), m.flags(), commit, m.scenes(), m.seeds(), date, true);
  }
}
