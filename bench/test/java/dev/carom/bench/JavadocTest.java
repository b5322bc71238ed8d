// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Scene;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** Runs the samples of the library's Javadoc; what they print stands behind each line in them. */
class JavadocTest {

  private static final Path SOURCES = Path.of("../src/main/java/dev/carom");
  private static final Pattern SAMPLE =
      Pattern.compile("<pre>\\{@code\\n(.*?)\\n[ *]*\\}</pre>", Pattern.DOTALL);
  private static final Pattern PRINTED =
      Pattern.compile("System\\.out\\.println\\(.*\\); // (.*)$", Pattern.MULTILINE);
  private static final Pattern SCENE =
      Pattern.compile("<pre>\\n([ *]*# .*?)</pre>", Pattern.DOTALL);
  private static final Pattern PICTURE =
      Pattern.compile("<img src=\"([^\"]*)\"\\s+alt=\"[^\"]{20}");

  @TempDir private Path folder;

  @TestFactory
  Stream<DynamicTest> samplesPrintWhatTheySay() throws IOException {
    List<DynamicTest> tests =
        sources().flatMap(file -> samples(file).map(text -> test(file, text))).toList();
    assertThat(tests).hasSizeGreaterThan(7);
    return tests.stream();
  }

  private DynamicTest test(Path file, String text) {
    String expected = find(PRINTED, text).collect(Collectors.joining("\n"));
    return DynamicTest.dynamicTest(
        file.getFileName().toString(),
        () -> {
          Path own = Files.createTempDirectory(folder, "sample");
          assertThat(JavaSample.run(text + "\n", own).strip()).isEqualTo(expected);
        });
  }

  @Test
  void theSceneFileCanBeRead() throws IOException {
    String javadoc = Files.readString(SOURCES.resolve("Scene.java"));
    List<String> files = find(SCENE, javadoc).map(JavadocTest::plain).toList();
    assertThat(files).hasSize(1);
    Scene scene = Scene.read(new StringReader(files.get(0)), "Javadoc");
    assertThat(scene.lineCount() * scene.pegCount() * scene.circleCount()).isEqualTo(1);
  }

  @Test
  void picturesAreThereAndToldInWords() throws IOException {
    Path pictures = Path.of("../src/main/javadoc/dev.carom/dev/carom/doc-files");
    String all = sources().map(JavadocTest::read).collect(Collectors.joining());
    List<String> shown = find(PICTURE, all).distinct().toList();
    assertThat(all.split("<img ", -1)).hasSize((int) find(PICTURE, all).count() + 1);
    try (Stream<Path> files = Files.list(pictures)) {
      assertThat(files.map(file -> "doc-files/" + file.getFileName()))
          .containsExactlyInAnyOrderElementsOf(shown);
    }
  }

  private static Stream<Path> sources() throws IOException {
    try (Stream<Path> files = Files.walk(SOURCES)) {
      return files.filter(file -> file.toString().endsWith(".java")).sorted().toList().stream();
    }
  }

  private static Stream<String> samples(Path file) {
    return find(SAMPLE, read(file)).map(JavadocTest::plain);
  }

  private static Stream<String> find(Pattern pattern, String text) {
    return pattern.matcher(text).results().map((MatchResult found) -> found.group(1));
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new AssertionError(file + " cannot be read", e);
    }
  }

  /** Without the stars at the margin. */
  private static String plain(String javadoc) {
    return Pattern.compile("^ *\\* ?", Pattern.MULTILINE).matcher(javadoc).replaceAll("");
  }
}
