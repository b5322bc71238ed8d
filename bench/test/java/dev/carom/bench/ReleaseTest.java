// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The version in the README and the changelog is that of the pom; {@code .ci/release} sets all
 * three.
 */
class ReleaseTest {

  private static final Path ROOT = Path.of("..");
  private static final String POM = "pom.xml";
  private static final String README = "README.md";
  private static final String CHANGELOG = ".github/CHANGELOG.md";
  private static final Pattern REVISION = Pattern.compile("<revision>(.*)</revision>");
  private static final Pattern SNIPPET =
      Pattern.compile("<artifactId>carom</artifactId>\\s*<version>(.*)</version>");
  private static final Pattern RELEASED =
      Pattern.compile("(?m)^## (\\d+\\.\\d+\\.\\d+), \\d{4}-\\d\\d-\\d\\d$");

  @TempDir private Path copy;

  @Test
  void theReadmeNamesTheLastRelease() throws Exception {
    demandOneVersion(ROOT);
  }

  @Test
  void aReleaseIsOneCommand() throws Exception {
    copyPages();
    assertThat(run("1.2.3-SNAPSHOT")).isZero();
    assertThat(run("1.2.3")).isZero();
    demandOneVersion(copy);
    assertThat(first(REVISION, POM)).isEqualTo("1.2.3");
    assertThat(first(RELEASED, CHANGELOG)).isEqualTo("1.2.3");
    assertThat(copy.resolve(README)).content().doesNotContain("unreleased", "not on Maven Central");
  }

  @Test
  void afterItTheNextVersionBegins() throws Exception {
    copyPages();
    assertThat(run("1.2.3-SNAPSHOT")).isZero();
    assertThat(run("1.2.3")).isZero();
    for (int times = 0; times < 2; times++) {
      assertThat(run("1.3.0-SNAPSHOT")).isZero();
      demandOneVersion(copy);
      assertThat(first(REVISION, POM)).isEqualTo("1.3.0-SNAPSHOT");
      assertThat(Files.readString(copy.resolve(CHANGELOG)))
          .containsOnlyOnce("## Unreleased\n\n## 1.2.3, ");
    }
  }

  @Test
  void whatIsNoVersionIsRefused() throws Exception {
    copyPages();
    for (String version : List.of("", "1.2", "v1.2.3", "1.2.3-RC1")) {
      assertThat(run(version)).as(version).isEqualTo(1);
    }
    assertThat(copy.resolve(POM)).hasSameTextualContentAs(ROOT.resolve(POM));
  }

  @Test
  void aReleaseNeedsNotes() throws Exception {
    copyPages();
    assertThat(run("1.2.3-SNAPSHOT")).isZero();
    assertThat(run("1.2.3")).isZero();
    assertThat(run("1.2.4")).isEqualTo(1);
    assertThat(first(REVISION, POM)).isEqualTo("1.2.3");
  }

  /** The README names the newest release; while there is none, what the pom builds. */
  private static void demandOneVersion(Path root) throws IOException {
    String revision = first(REVISION, root.resolve(POM));
    Matcher released = RELEASED.matcher(Files.readString(root.resolve(CHANGELOG)));
    String newest = released.find() ? released.group(1) : revision;
    assertThat(first(SNIPPET, root.resolve(README))).isEqualTo(newest);
    if (!revision.endsWith("-SNAPSHOT")) {
      assertThat(newest).as("the changelog's newest section").isEqualTo(revision);
    }
  }

  private String first(Pattern pattern, String page) throws IOException {
    return first(pattern, copy.resolve(page));
  }

  private static String first(Pattern pattern, Path page) throws IOException {
    Matcher found = pattern.matcher(Files.readString(page));
    assertThat(found.find()).as("%s in %s", pattern, page).isTrue();
    return found.group(1);
  }

  private void copyPages() throws IOException {
    for (String name : List.of(POM, README, CHANGELOG, ".ci/release")) {
      Files.createDirectories(copy.resolve(name).getParent());
      Files.copy(ROOT.resolve(name), copy.resolve(name));
    }
  }

  private int run(String version) throws IOException, InterruptedException {
    Path output = copy.resolve("output.txt");
    Process process =
        new ProcessBuilder("bash", copy.resolve(".ci/release").toString(), version)
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    assertThat(process.waitFor(10, TimeUnit.MINUTES)).isTrue();
    return process.exitValue();
  }
}
