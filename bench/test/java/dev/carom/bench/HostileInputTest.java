// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.management.ThreadMXBean;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SceneFormatException;
import dev.carom.Snapshot;
import dev.carom.SnapshotBytes;
import dev.carom.World;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringReader;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** As SECURITY.md says of input from strangers: memory is in proportion to the length read. */
class HostileInputTest {

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  /** Bytes allocated for each byte, or character, that is read. Measured: 3 to 19. */
  private static final int MOST = 40;

  private static final int LONG = 1_000_000;

  private static SceneBuilder pegs(int count) {
    SceneBuilder scene = Scene.builder();
    for (int i = 0; i < count; i++) {
      scene.peg(3 * i, 0, 1).velocity(0, 1);
    }
    return scene;
  }

  private static byte[] snapshot(SceneBuilder scene) {
    return SnapshotBytes.of(new World(scene.build()).snapshot());
  }

  /** A list that is copied for each of its elements would allocate the square. */
  @Test
  void aSnapshotOfMuchThatMovesTakesMemoryInProportion() throws IOException {
    byte[] bytes = snapshot(pegs(8_000));
    long before = THREADS.getCurrentThreadAllocatedBytes();
    assertThat(Snapshot.read(new ByteArrayInputStream(bytes)).now()).isZero();
    assertThat(THREADS.getCurrentThreadAllocatedBytes() - before)
        .isLessThan((long) MOST * bytes.length);
  }

  /**
   * Whatever number of things it claims to hold: memory comes with the bytes, not with the claim.
   */
  @Test
  void aSnapshotThatClaimsMoreThanItHoldsTakesNoMemory() {
    byte[] whole = snapshot(pegs(3).circle(50, 50, 1, 1, 1));
    for (int at = 0; at + Integer.BYTES <= whole.length; at++) {
      byte[] bytes = whole.clone();
      ByteBuffer.wrap(bytes).putInt(at, 0x0fff_ffff);
      long before = THREADS.getCurrentThreadAllocatedBytes();
      assertThatThrownBy(() -> Snapshot.read(new ByteArrayInputStream(bytes)))
          .as("at byte %d", at)
          .isExactlyInstanceOf(IOException.class)
          .hasMessageStartingWith("snapshot ");
      assertThat(THREADS.getCurrentThreadAllocatedBytes() - before)
          .as("at byte %d", at)
          .isLessThan(LONG);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"x", "circle,", "circle,1", "circle,0,0,1,1,1,mass=1", ",", "\"", "=", "#"})
  void aLongRowIsRefusedInFewWordsAndMemoryInProportion(String start) {
    String text = start + start.substring(start.length() - 1).repeat(LONG) + "\nx";
    long before = THREADS.getCurrentThreadAllocatedBytes();
    assertThatThrownBy(() -> Scene.read(new StringReader(text), "scene.csv"))
        .isExactlyInstanceOf(SceneFormatException.class)
        .satisfies(refusal -> assertThat(refusal.getMessage()).hasSizeLessThan(300));
    assertThat(THREADS.getCurrentThreadAllocatedBytes() - before)
        .isLessThan((long) MOST * text.length());
  }
}
