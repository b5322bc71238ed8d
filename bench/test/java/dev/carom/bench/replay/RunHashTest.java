// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import org.junit.jupiter.api.Test;

class RunHashTest {

  private static SceneBuilder box() {
    return Scene.builder().collide(false).bounds(0, 0, 100, 100).line(20, 50, 80, 50);
  }

  private static String hash(Scene scene, int frames) {
    return RunHash.of(scene, frames).hex();
  }

  @Test
  void isThatOfAllThatHappens() {
    Scene scene = box().circle(30, 20, 5, 3, 4).build();

    assertThat(hash(scene, 100)).matches("[0-9a-f]{64}").isEqualTo(hash(scene, 100));
    assertThat(hash(scene, 100)).isNotEqualTo(hash(scene, 99));
    assertThat(RunHash.of(scene, 100).impacts()).isPositive();
  }

  @Test
  void tellsOneUlpOfOneNumber() {
    Scene scene = box().circle(30, 20, 5, 3, 4).build();
    Scene other = box().circle(30, 20, 5, 3, Math.nextUp(4.0)).build();

    assertThat(hash(other, 100)).isNotEqualTo(hash(scene, 100));
  }

  /** The same places at the end, another impact on the way. */
  @Test
  void tellsAnImpactThatLeavesNoTrace() {
    Scene scene = box().circle(20, 20, 5, 0, 0).circle(60, 20, 5, 4, 0).build();
    SceneBuilder builder = box().circle(20, 20, 5, 0, 0).circle(60, 20, 5, 4, 0);
    Scene sensed = builder.peg(75, 20, 2).response(Response.SENSOR).build();

    assertThat(hash(sensed, 5)).isNotEqualTo(hash(scene, 5));
    assertThat(hash(sensed, 1)).isEqualTo(hash(scene, 1));
  }

  /** More impacts than fit into what is hashed at once. */
  @Test
  void goldenRunsHaveManyImpacts() throws Exception {
    for (GoldenRun run : GoldenRun.values()) {
      RunHash hash = run.play(false);
      assertThat(hash.impacts()).as(run.label(false)).isGreaterThan(5_000);
      assertThat(StoredHashes.read().of(run.label(false))).isEqualTo(hash.hex());
    }
  }
}
