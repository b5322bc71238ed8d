// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** A simple name means one thing: a reader of an import need not look at its package. */
class SimpleNamesTest {

  private static final Path SOURCES = Path.of("main/java");

  private static List<Path> files() throws IOException {
    try (Stream<Path> all = Files.walk(SOURCES)) {
      return all.filter(file -> file.toString().endsWith(".java")).toList();
    }
  }

  private static Stream<String> names() throws IOException {
    return files().stream()
        .map(file -> file.getFileName().toString().replace(".java", ""))
        .filter(name -> !name.equals("package-info"));
  }

  @Test
  void noTwoClassesOfTheHarnessShareOne() throws IOException {
    assertThat(names()).hasSizeGreaterThan(200).doesNotHaveDuplicates();
  }

  @Test
  void noClassSharesOneWithThePublicTypesOfTheLibrary() throws IOException {
    assertThat(names().filter(SimpleNamesTest::isPublicInTheLibrary)).isEmpty();
  }

  private static boolean isPublicInTheLibrary(String name) {
    try {
      return Modifier.isPublic(Class.forName("dev.carom." + name).getModifiers());
    } catch (ClassNotFoundException e) {
      return false;
    }
  }

  @Test
  void noClassStandsInThePackageOfTheLibrary() throws IOException {
    assertThat(files()).allMatch(file -> file.startsWith(SOURCES.resolve("dev/carom/bench")));
  }
}
