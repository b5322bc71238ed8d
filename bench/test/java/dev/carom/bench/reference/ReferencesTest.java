// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Scene;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.DeflaterInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReferencesTest {

  /** To half a thousandth, and what float leaves of it. */
  private static final double STORED = 0.00052;

  private static void assertSame(Reference stored, Reference computed, int frames) {
    assertThat(stored.circles()).isEqualTo(computed.circles());
    for (int frame = 0; frame <= frames; frame++) {
      for (int i = 0; i < stored.circles(); i++) {
        assertThat(stored.x(frame, i)).isEqualTo(computed.x(frame, i));
        assertThat(stored.y(frame, i)).isEqualTo(computed.y(frame, i));
        assertThat(stored.vx(frame, i)).isEqualTo(computed.vx(frame, i));
        assertThat(stored.vy(frame, i)).isEqualTo(computed.vy(frame, i));
        assertThat(stored.log10Conditioning(frame, i))
            .isCloseTo(computed.log10Conditioning(frame, i), within(STORED));
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"base-1, 60", "base-2, 600", "base-3, 60", "fast-1, 30", "radii, 60", "falling, 60"})
  void whatIsStoredIsWhatIsComputed(String name, int frames) throws IOException {
    Reference stored = References.load(name);
    assertThat(stored.frames()).isEqualTo(600);
    Truth truth = Truth.of(References.scene(name), frames, () -> {});
    assertSame(stored, truth, frames);
  }

  @Test
  void whatIsWrittenIsRead(@TempDir Path folder) throws IOException {
    Truth truth = Truth.of(References.scene("fast-1"), 20, () -> {});
    long size = References.write(truth, "fast-1", folder.resolve("new"));
    Path file = folder.resolve("new/fast-1.flights");
    assertThat(file).hasSize(size);
    try (InputStream in = Files.newInputStream(file)) {
      assertSame(ReferenceReader.read(in, "fast-1"), truth, 20);
    }
  }

  /** Far fewer than frames, or the files would be ten times as large. */
  @Test
  void aStretchTellsOfManyFrames() throws IOException {
    Scene scene = References.scene("base-1");
    Truth truth = Truth.of(scene, 60, () -> {});
    int stretches = 0;
    int flights = 0;
    for (int i = 0; i < 100; i++) {
      stretches += ReferenceWriter.stretches(truth.course(i), truth.gravity()).size();
      flights += truth.course(i).flights[60] + 1;
    }
    assertThat(stretches).isBetween(100, flights);
  }

  @Test
  void conditioningBeyond300IsInfinite() throws IOException {
    Reference fast = References.load("fast-1");
    double worst = 0;
    double most = 0;
    for (int i = 0; i < 100; i++) {
      double log = fast.log10Conditioning(600, i);
      worst = Math.max(worst, log);
      most = log < Double.POSITIVE_INFINITY ? Math.max(most, log) : most;
    }
    assertThat(worst).isInfinite();
    assertThat(most).isBetween(200.0, 300.0);
  }

  @Test
  void namesWhatIsNotThere() {
    assertThatThrownBy(() -> References.load("base-9"))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("base-9")
        .hasMessageContaining("expected one of the scenes [base-1");
    assertThatThrownBy(() -> References.scene("base-9")).isInstanceOf(IOException.class);
  }

  @Test
  void refusesAnotherVersion() {
    InputStream in = new DeflaterInputStream(new ByteArrayInputStream(new byte[] {0, 0, 0, 9}));
    assertThatThrownBy(() -> ReferenceReader.read(in, "base-1"))
        .hasMessage("base-1: version 9: expected 1 or 2");
  }
}
