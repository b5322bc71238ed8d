// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.carom.bench.replay.GoldenRun;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The golden runs have the stored hashes under the interpreter, without the processor's instruction
 * for a fused multiply-add, under each compiler, and on another JDK: that of the environment
 * variable {@code CAROM_SECOND_JDK}, or one of another version in the folder where this one is.
 */
class SameBitsIT {

  private static final Path JAR = Path.of("target/carom-bench.jar").toAbsolutePath();
  private static final Path HOME = Path.of(System.getProperty("java.home"));

  /** As many again are long. */
  private static final int RUNS = GoldenRun.values().length;

  @TempDir private Path folder;

  /** These take too long for the long runs. */
  @ParameterizedTest
  @ValueSource(strings = {"-Xint", "-XX:-UseFMA"})
  void interpreterAndNoFma(String option) throws Exception {
    demandStoredHashes(HOME, RUNS, option, "-jar", JAR.toString(), "hash");
  }

  @ParameterizedTest
  @ValueSource(strings = {"-XX:TieredStopAtLevel=1", "-XX:-TieredCompilation"})
  void compilers(String option) throws Exception {
    demandStoredHashes(HOME, 2 * RUNS, option, "-jar", JAR.toString(), "hash", "--long");
  }

  @Test
  void anotherJdk() throws Exception {
    Optional<Path> other = secondJdk();
    assumeTrue(
        other.isPresent(),
        "skipped: no second JDK beside " + HOME + "; CAROM_SECOND_JDK can name one");
    System.out.println("the second JDK is " + other.get() + ", " + version(other.get()));
    demandStoredHashes(other.get(), 2 * RUNS, "-jar", JAR.toString(), "hash", "--long");
  }

  private void demandStoredHashes(Path home, int runs, String... arguments)
      throws IOException, InterruptedException {
    Path output = folder.resolve("output.txt");
    List<String> command = new ArrayList<>();
    command.add(home.resolve("bin").resolve("java").toString());
    command.addAll(List.of(arguments));
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    assertThat(process.waitFor(10, TimeUnit.MINUTES)).isTrue();
    assertThat(process.exitValue()).as(Files.readString(output)).isZero();
    assertThat(Files.readAllLines(output))
        .hasSize(runs)
        .allSatisfy(line -> assertThat(line).endsWith("as stored"));
  }

  private static Optional<Path> secondJdk() throws IOException {
    String named = System.getenv("CAROM_SECOND_JDK");
    if (named != null) {
      return Optional.of(Path.of(named));
    }
    String own = version(HOME);
    try (Stream<Path> beside = Files.list(HOME.toRealPath().getParent())) {
      return beside
          .sorted()
          .filter(home -> Files.isExecutable(home.resolve("bin").resolve("java")))
          .filter(home -> !version(home).isEmpty() && !version(home).equals(own))
          .findFirst();
    }
  }

  /** The version in a JDK's file "release"; empty if it has none. */
  private static String version(Path home) {
    Properties release = new Properties();
    try (InputStream in = Files.newInputStream(home.resolve("release"))) {
      release.load(in);
    } catch (IOException e) {
      return "";
    }
    return release.getProperty("JAVA_VERSION", "");
  }
}
