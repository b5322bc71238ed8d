// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.state.EngineOptions;
import java.util.List;
import java.util.Random;

/**
 * A world that is restored from a snapshot of another one, again and again, and told the same as
 * that one in between: the snapshots of the two are equal at every moment, to the byte.
 */
final class RestoredTwin {

  private final Scene scene;
  private final EngineOptions options;
  private final Random random;
  private World twin;

  RestoredTwin(Scene scene, EngineOptions options, Random random) {
    this.scene = scene;
    this.options = options;
    this.random = random;
    twin = new World(scene, options);
  }

  /** The world itself. */
  World world() {
    return twin;
  }

  /** Goes, one time in three, to where the other one is: as it is in memory, or as bytes tell. */
  void maybeFollow(World world) {
    if (random.nextInt(3) == 0) {
      follow(world);
    }
  }

  /** Goes to where the other one is. */
  void follow(World world) {
    Snapshot snapshot = world.snapshot();
    if (random.nextBoolean()) {
      twin = new World(scene, options);
    }
    twin.restore(random.nextBoolean() ? snapshot : SnapshotBytes.copy(snapshot));
    compare(world);
  }

  /**
   * Advances it in one step, in which the same impacts happen as in the other one, and returns
   * false if that took more than its budget, which is not saved.
   */
  boolean advance(World world, double end, List<Impact> rows) {
    if (!twin.advanceTo(end, Run.WORK)) {
      return false;
    }
    assertThat(Run.rows(twin.impacts())).as("restored").isEqualTo(rows);
    compare(world);
    return true;
  }

  void compare(World world) {
    Snapshot snapshot = world.snapshot();
    Snapshot ofTwin = twin.snapshot();
    assertThat(ofTwin).as("snapshot of the restored one").isEqualTo(snapshot);
    assertThat(ofTwin).hasSameHashCodeAs(snapshot);
    assertThat(SnapshotBytes.of(ofTwin)).isEqualTo(SnapshotBytes.of(snapshot));
  }
}
