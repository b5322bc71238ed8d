// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Compiles and runs the README's Java as it is printed there, and compares what it prints. */
class ReadmeTest {

  private static final Path README = Path.of("..", "README.md");

  @TempDir Path folder;

  @Test
  void theFirstProgramPrintsWhatTheReadmeSays() throws Exception {
    String printed = JavaSample.run(block("java", 0), folder);
    assertThat(printed.strip()).isEqualTo(block("", 0).strip());
  }

  /** The text of the n-th fenced block of a language; "" for blocks that name none. */
  private static String block(String language, int n) throws IOException {
    Matcher fences =
        Pattern.compile("^```(\\w*)\\n(.*?)^```$", Pattern.MULTILINE | Pattern.DOTALL)
            .matcher(Files.readString(README));
    int seen = 0;
    while (fences.find()) {
      if (fences.group(1).equals(language) && seen++ == n) {
        return fences.group(2);
      }
    }
    throw new AssertionError("no block " + n + " of \"" + language + "\" in the README");
  }
}
