// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.World;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.tools.ToolProvider;

/** Statements from a text for people, compiled against the library and run. */
final class JavaSample {

  private JavaSample() {}

  /** Gives what they print. */
  static String run(String statements, Path folder) throws Exception {
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
