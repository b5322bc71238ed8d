// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.World;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** The program of the guide about sweeps, as printed; {@code .ci/sweeps} has it on Spark, too. */
@Isolated("its programs print")
class SweepsGuideTest {

  private static final Path GUIDE =
      Path.of("../src/main/javadoc/dev.carom/dev/carom/doc-files/sweeps.html");

  @TempDir private static Path out;

  @BeforeAll
  static void compile() throws IOException {
    for (String name : new String[] {"Sweep", "Merge"}) {
      String id = name.equals("Sweep") ? "program" : "merge";
      Files.writeString(out.resolve(name + ".java"), block(id));
    }
    String library =
        Path.of(World.class.getProtectionDomain().getCodeSource().getLocation().getPath())
            .toString();
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    int exit =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                errors,
                "-proc:none",
                "-d",
                out.toString(),
                "-cp",
                library + File.pathSeparator + out,
                out.resolve("Sweep.java").toString(),
                out.resolve("Merge.java").toString());
    assertThat(exit).as(errors.toString(StandardCharsets.UTF_8)).isZero();
  }

  private static String block(String id) throws IOException {
    String page = Files.readString(GUIDE);
    String opening = "<pre id=\"" + id + "\"><code>";
    int start = page.indexOf(opening) + opening.length();
    return page.substring(start, page.indexOf("</code>", start))
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&amp;", "&");
  }

  @Test
  void fourJobsAddUpToTheLineOfTheGuide() throws Exception {
    StringBuilder lines = new StringBuilder();
    for (int first = 0; first < 10_000; first += 2_500) {
      lines.append(print("Sweep", "", "--seeds", first + ".." + (first + 2_500)));
    }
    assertThat(print("Merge", lines.toString())).isEqualTo(block("output"));
  }

  /** The same as the four jobs, but on all cores at once. */
  @Test
  void oneStreamPrintsTheLineOfTheGuide() throws Exception {
    assertThat(print("Sweep", "", "--seeds", "0..10000")).isEqualTo(block("output"));
  }

  private static String print(String program, String in, String... args) throws Exception {
    PrintStream screen = System.out;
    InputStream keys = System.in;
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {out.toUri().toURL()})) {
      System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
      System.setIn(new ByteArrayInputStream(in.getBytes(StandardCharsets.UTF_8)));
      loader.loadClass(program).getMethod("main", String[].class).invoke(null, (Object) args);
    } finally {
      System.setOut(screen);
      System.setIn(keys);
    }
    return printed.toString(StandardCharsets.UTF_8).replace("\r\n", "\n");
  }
}
