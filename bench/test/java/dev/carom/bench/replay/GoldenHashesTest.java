// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class GoldenHashesTest {

  private static final Path STORED = Path.of("main/resources/dev/carom/bench/hashes.properties");

  @Test
  void printsTheStoredLinesOfTheShortRuns() throws Exception {
    List<String> stored =
        Files.readAllLines(STORED).stream().filter(line -> line.matches("[a-z]+=.*")).toList();
    assertThat(stored).hasSize(GoldenRun.values().length);
    assertThat(printed().lines()).containsExactlyElementsOf(stored);
  }

  private static String printed() throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    PrintStream before = System.out;
    try {
      System.setOut(new PrintStream(bytes, true, StandardCharsets.UTF_8));
      GoldenHashes.main();
    } finally {
      System.setOut(before);
    }
    return bytes.toString(StandardCharsets.UTF_8);
  }
}
