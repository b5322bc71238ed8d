// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** ARCHITECTURE.md names every file of the library, and no other. */
class ArchitecturePageTest {

  private static final Path PAGE = Path.of("../.github/ARCHITECTURE.md");
  private static final Path SOURCES = Path.of("main/java/dev/carom");
  private static final Pattern ROW = Pattern.compile("(?m)^\\|[^|]*\\|[^|]*\\|([^|]*)\\|$");
  private static final Pattern NAME = Pattern.compile("`([\\w-]+)`");

  @Test
  void whereToLookNamesEveryFile() throws IOException {
    String page = Files.readString(PAGE);
    String section = page.substring(page.indexOf("## Where to look"));
    Set<String> named =
        ROW.matcher(section.substring(0, section.indexOf("## Where to change")))
            .results()
            .flatMap(row -> NAME.matcher(row.group(1)).results())
            .map(name -> name.group(1))
            .collect(Collectors.toCollection(TreeSet::new));
    assertThat(named).containsExactlyElementsOf(sources());
  }

  @Test
  void whereToChangeNamesFilesThatExist() throws IOException {
    String page = Files.readString(PAGE);
    String section = page.substring(page.indexOf("## Where to change what"));
    Set<String> known = sources();
    known.addAll(Set.of("VERSION", "CircleFieldsTest", "package-info"));
    assertThat(NAME.matcher(section).results().map(name -> name.group(1)))
        .hasSizeGreaterThan(20)
        .isSubsetOf(known);
  }

  private static Set<String> sources() throws IOException {
    try (Stream<Path> files = Files.walk(SOURCES)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(".java"))
          .map(name -> name.replace(".java", ""))
          .collect(Collectors.toCollection(TreeSet::new));
    }
  }
}
