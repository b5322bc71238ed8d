// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Builds and runs a small program against the packed library, as a project would that depends on
 * it: on the class path and on the module path, with no module of Java's but the base.
 */
class ConsumerIT {

  private static final Path LIBRARY = Path.of("..", "src", "target").toAbsolutePath();
  private static final String PROGRAM =
      """
      package app;

      import dev.carom.Scene;
      import dev.carom.World;

      public class Main {
        public static void main(String[] args) {
          World world =
              new World(Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 10, 8, 0).build());
          world.step(6);
          System.out.println(world.impacts().time(0) + " in " + World.class.getModule().getName());
        }
      }
      """;
  private static final String MODULE = "module app { requires dev.carom; }\n";

  @TempDir private Path folder;

  @Test
  void runsOnTheClassPath() throws Exception {
    Path out = folder.resolve("out");
    run("javac", "-Werror", "-Xlint:all", "-cp", jar(""), "-d", out, main());

    String printed = run("java", "-cp", jar("") + File.pathSeparator + out, "app.Main");

    assertThat(printed).isEqualTo("5.0 in null");
  }

  @Test
  void runsOnTheModulePathOnTheBaseModuleAlone() throws Exception {
    Path out = folder.resolve("out");
    Path module = source("module-info.java", MODULE);
    run("javac", "-Werror", "-Xlint:all", "-p", jar(""), "-d", out, module, main());

    String path = jar("") + File.pathSeparator + out;
    String printed =
        run("java", "--limit-modules", "java.base,dev.carom", "-p", path, "-m", "app/app.Main");

    assertThat(printed).isEqualTo("5.0 in dev.carom");
  }

  /** A run-time image of two modules: Java's base and the library, beside the program. */
  @Test
  void runsInAnImageOfItsOwn() throws Exception {
    Path out = folder.resolve("out");
    Path image = folder.resolve("image");
    String path = jar("") + File.pathSeparator + out;
    run("javac", "-p", jar(""), "-d", out, source("module-info.java", MODULE), main());
    run("jlink", "-p", path, "--add-modules", "app", "--output", image);

    assertThat(run(image, "java", "--list-modules").lines().map(line -> line.split("@", -1)[0]))
        .containsExactlyInAnyOrder("app", "dev.carom", "java.base");
    assertThat(run(image, "java", "-m", "app/app.Main")).isEqualTo("5.0 in dev.carom");
  }

  @Test
  void exportsOnePackageAndRequiresTheBaseOnly() throws Exception {
    String described = run("jar", "--describe-module", "--file", jar(""));

    assertThat(
            described
                .lines()
                .skip(1)
                .filter(line -> !line.isBlank())
                .filter(line -> !line.startsWith("contains dev.carom.internal.")))
        .containsExactlyInAnyOrder("exports dev.carom", "requires java.base mandated");
  }

  @Test
  void thePublishedPomHasNoParentAndNoDependencies() throws Exception {
    String inJar = entry("", "META-INF/maven/dev.carom/carom/pom.xml");

    assertThat(inJar)
        .contains("<groupId>dev.carom</groupId>", "<artifactId>carom</artifactId>", "<licenses>")
        .doesNotContain("<parent>", "<dependenc", "${", "<build>", "<profile");
    assertThat(LIBRARY.resolve(".flattened-pom.xml")).content().isEqualTo(inJar);
  }

  @Test
  void sourcesAndJavadocStandBesideIt() throws Exception {
    assertThat(entry("-sources", "dev/carom/World.java")).contains("public final class World");
    assertThat(entry("-javadoc", "dev.carom/dev/carom/World.html")).contains("Class World");
    assertThat(entry("-javadoc", "dev.carom/dev/carom/doc-files/rules.html")).contains("<h1");
    assertThat(entry("-javadoc", "dev.carom/dev/carom/doc-files/recipes.html")).contains("<h1");
    assertThat(entry("-javadoc", "dev.carom/dev/carom/doc-files/line.svg")).contains("<svg");
    assertThat(entry("", "META-INF/LICENSE")).contains("Apache License");
  }

  /** The path of a jar of the library: "" for the classes, else "-sources" or "-javadoc". */
  private static String jar(String classifier) {
    String version = System.getProperty("carom.version");
    return LIBRARY.resolve("carom-" + version + classifier + ".jar").normalize().toString();
  }

  private static String entry(String classifier, String name) throws IOException {
    try (JarFile file = new JarFile(jar(classifier))) {
      assertThat(file.getEntry(name)).as("%s in %s", name, file.getName()).isNotNull();
      try (InputStream in = file.getInputStream(file.getEntry(name))) {
        return new String(in.readAllBytes(), StandardCharsets.UTF_8);
      }
    }
  }

  private Path main() throws IOException {
    return source("Main.java", PROGRAM);
  }

  private Path source(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }

  /** Runs one of this JDK's tools, and gives what it printed. */
  private String run(String tool, Object... args) throws IOException, InterruptedException {
    return run(Path.of(System.getProperty("java.home")), tool, args);
  }

  private String run(Path home, String tool, Object... args)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(home.resolve("bin").resolve(tool).toString());
    Stream.of(args).map(Object::toString).forEach(command::add);
    Path output = Files.createTempFile(folder, tool, ".txt");
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().remove("JAVA_TOOL_OPTIONS");
    Process process = builder.redirectOutput(output.toFile()).start();
    assertThat(process.waitFor(10, TimeUnit.MINUTES)).isTrue();
    String printed = Files.readString(output).strip();
    assertThat(process.exitValue()).as("%s: %s", command, printed).isZero();
    return printed;
  }
}
