// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.World;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Compiles and runs the README's Java as it is printed there, and compares what it prints. */
class ReadmeTest {

  private static final Path README = Path.of("..", "README.md");

  @TempDir Path folder;

  @Test
  void theTenLinesPrintWhatTheReadmeSays() throws Exception {
    String printed = run(block("java", 0));
    assertThat(printed.strip()).isEqualTo(block("", 0).strip());
  }

  @Test
  void editsPrintWhatTheReadmeSays() throws Exception {
    String printed = run(block("java", 1));
    assertThat(printed.strip()).isEqualTo(block("", 3).strip());
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

  private String run(String statements) throws Exception {
    Path source = folder.resolve("Sample.java");
    String text =
        "import dev.carom.*;\nimport java.util.*;\n\npublic class Sample {\n"
            + "public static void main(String[] args) {\n"
            + statements
            + "}\n}\n";
    Files.writeString(source, text);
    String classes = World.class.getProtectionDomain().getCodeSource().getLocation().getPath();
    ByteArrayOutputStream complaints = new ByteArrayOutputStream();
    int failed =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null, null, complaints, "-cp", classes, "-d", folder.toString(), source.toString());
    assertThat(failed).as(complaints.toString(StandardCharsets.UTF_8)).isZero();
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    PrintStream before = System.out;
    URL[] urls = {folder.toUri().toURL(), Path.of(classes).toUri().toURL()};
    try (URLClassLoader loader = new URLClassLoader(urls, ClassLoader.getPlatformClassLoader())) {
      System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
      loader.loadClass("Sample").getMethod("main", String[].class).invoke(null, (Object) null);
    } finally {
      System.setOut(before);
    }
    return printed.toString(StandardCharsets.UTF_8);
  }
}
