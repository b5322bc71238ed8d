// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Kind;
import dev.carom.Outline;
import dev.carom.Scene;
import dev.carom.Vec2;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The page of the harness tells of every command, and of scene files as they are read. The commands
 * that pages print are understood; {@code .ci/commands} types them.
 */
class HarnessPageTest {

  private static final Path PAGE = Path.of("README.md");

  @Test
  void everyCommandStandsInATable() throws IOException {
    List<String> rows = all("(?m)^\\| `(?:measure )?(\\w+)` \\|");
    Set<String> expected = new TreeSet<>(CaromBench.commandLine().getSubcommands().keySet());
    expected.remove("measure");
    expected.addAll(MeasureCommand.SERIES);
    assertThat(rows).containsExactlyInAnyOrderElementsOf(expected);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "../README.md",
        "README.md",
        "PERFORMANCE.md",
        "../.github/CONTRIBUTING.md",
        "../.github/ISSUE_TEMPLATE/bug.yml",
        "../src/main/javadoc/dev.carom/dev/carom/doc-files/rules.html"
      })
  void everyPrintedCommandIsUnderstood(String page) throws IOException {
    String text = Files.readString(Path.of(page)).replaceAll("\n(?!java)", " ");
    List<String> printed =
        Pattern.compile("(?:[`>]bench|java -jar bench/target/carom-bench\\.jar) ([a-z][^`<#\n]*)")
            .matcher(text)
            .results()
            .map(match -> match.group(1).strip())
            .toList();
    assertThat(printed)
        .isNotEmpty()
        .allSatisfy(
            words -> CaromBench.commandLine().parseArgs(CaromBench.words(words.split(" "))));
  }

  @Test
  void theSampleOfASceneFileIsRead() throws IOException {
    String sample = all("(?s)## Scene files.*?```\n(.*?)```").get(0);
    Scene scene = Scene.read(new StringReader(sample), "the sample");
    assertThat(scene.count(Kind.LINE)).isEqualTo(4);
    assertThat(scene.shape(Kind.LINE, 2)).isInstanceOf(Outline.class);
    assertThat(scene.velocity(Kind.LINE, 3)).isEqualTo(new Vec2(2, 0));
    assertThat(scene.count(Kind.PEG)).isEqualTo(2);
    assertThat(scene.count(Kind.CIRCLE)).isEqualTo(3);
    assertThat(scene.collide()).isFalse();
    assertThat(scene.gravity()).isEqualTo(new Vec2(0, -0.5));
    assertThat(scene.warnings()).isEmpty();
  }

  private static List<String> all(String pattern) throws IOException {
    return Pattern.compile(pattern)
        .matcher(Files.readString(PAGE))
        .results()
        .map(match -> match.group(1))
        .toList();
  }
}
