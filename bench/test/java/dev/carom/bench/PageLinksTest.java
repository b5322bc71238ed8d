// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Links and pictures of the pages lead to files that exist, and to headings in them. */
class PageLinksTest {

  private static final Path ROOT = Path.of("..");

  @ParameterizedTest
  @ValueSource(
      strings = {
        "README.md",
        "bench/README.md",
        "bench/PERFORMANCE.md",
        ".github/ARCHITECTURE.md",
        ".github/CONTRIBUTING.md",
        ".github/DECISIONS.md",
        ".github/SECURITY.md"
      })
  void leadSomewhere(String name) throws IOException {
    Path page = ROOT.resolve(name);
    List<MatchResult> links =
        Pattern.compile("\\]\\((?!https?:)([^)#]*)(#[^)]+)?\\)")
            .matcher(Files.readString(page))
            .results()
            .toList();
    assertThat(links).isNotEmpty();
    for (MatchResult link : links) {
      Path target = link.group(1).isEmpty() ? page : page.resolveSibling(link.group(1));
      assertThat(target).as(link.group()).exists();
      if (link.group(2) != null) {
        assertThat(headings(target)).as(link.group()).contains(link.group(2));
      }
    }
  }

  /** As GitHub names them. */
  private static List<String> headings(Path page) throws IOException {
    return Pattern.compile("(?m)^#+ (.*)$")
        .matcher(Files.readString(page))
        .results()
        .map(heading -> heading.group(1).toLowerCase(Locale.ROOT))
        .map(text -> "#" + text.replaceAll("[^\\w -]", "").replace(' ', '-'))
        .toList();
  }
}
