// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import dev.carom.Filter;
import dev.carom.Impact;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Snapshot;
import dev.carom.SnapshotBytes;
import dev.carom.World;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;

/**
 * Input from outside is taken as a whole, or refused with a message; nothing else. In an ordinary
 * run each test gets its stored inputs; with {@code JAZZER_FUZZ=1} in the environment Jazzer looks
 * for new ones, one test at a time, led by coverage.
 */
class InputFuzzIT {

  private static final int SUM = Long.BYTES;
  private static final String WHOLE = "InputFuzzITInputs/snapshot/whole.bin";

  @FuzzTest(maxDuration = "10m")
  void sceneFile(byte[] data) throws IOException {
    Scene scene;
    try {
      scene = Scene.read(new StringReader(new String(data, StandardCharsets.UTF_8)), "fuzz.csv");
    } catch (IOException e) {
      assertThat(e).hasMessageStartingWith("fuzz.csv:");
      return;
    }
    StringBuilder text = new StringBuilder();
    scene.write(text);
    assertThat(Scene.read(new StringReader(text.toString()), "again")).isEqualTo(scene);
    new World(scene);
  }

  /** The check sum is put right, so that what is behind it is reached. */
  private static Snapshot read(byte[] data) throws IOException {
    byte[] whole = Arrays.copyOf(data, data.length + SUM);
    CRC32 sum = new CRC32();
    sum.update(data);
    ByteBuffer.wrap(whole, data.length, SUM).putLong(sum.getValue());
    return Snapshot.read(new ByteArrayInputStream(whole));
  }

  /**
   * A moving line, a peg, filters, gravity, circles that collide, and one that ignores the rest.
   */
  private static byte[] bytesOfWorld() throws IOException {
    Scene scene =
        Scene.builder()
            .bounds(0, 0, 100, 60)
            .gravity(0, -0.01)
            .peg(50, 20, 5)
            .line(10, 10, 40, 15)
            .filter(new Filter(2, 7))
            .circle(20, 40, 3, 1.5, 0.5)
            .circle(70, 30, 4, -1, 0.25)
            .circle(30, 50, 2, 0.5, -1)
            .filter(new Filter(4, 2))
            .build();
    World world = new World(scene);
    world.setVelocity(Kind.LINE, 0, 0.25, 0.125);
    world.advanceTo(20);
    byte[] whole = SnapshotBytes.of(world.snapshot());
    return Arrays.copyOf(whole, whole.length - SUM);
  }

  /** An input of an older version would be refused by its number. */
  @Test
  void theStoredSnapshotIsOfThisVersion() throws IOException {
    if ("write".equals(System.getProperty("carom.fuzz"))) {
      Files.write(Path.of("test/resources/dev/carom/bench/cli", WHOLE), bytesOfWorld());
    }
    try (InputStream in = getClass().getResourceAsStream(WHOLE)) {
      assertThat(in.readAllBytes())
          .as("write it with -Dcarom.fuzz=write")
          .isEqualTo(bytesOfWorld());
    }
  }

  @FuzzTest(maxDuration = "10m")
  void snapshot(byte[] data) throws IOException {
    Snapshot snapshot;
    try {
      snapshot = read(data);
    } catch (IOException e) {
      assertThat(e.getMessage()).isNotBlank();
      return;
    }
    ByteArrayInputStream written = new ByteArrayInputStream(SnapshotBytes.of(snapshot));
    assertThat(Snapshot.read(written)).isEqualTo(snapshot);
  }

  @FuzzTest(maxDuration = "10m")
  void queries(byte[] data) {
    CastReader reader = new CastReader("fuzz.csv");
    try {
      reader.read(new StringReader(new String(data, StandardCharsets.UTF_8)));
    } catch (IOException e) {
      assertThat(e).hasMessageStartingWith("fuzz.csv:");
      return;
    }
    int end = reader.kind().header().split(",", -1).length - 1; // T is the last of the header
    for (double[] query : reader.queries()) {
      Optional<Impact> answer = reader.kind().cast(query);
      // + 0 turns a window of -0 into one of 0, which it is.
      double window = query[end] + 0.0;
      answer.ifPresent(impact -> assertThat(impact.time()).isBetween(0.0, window));
    }
  }
}
