// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.methods.PlainScene;
import java.util.List;

/**
 * The plan of a replay.
 *
 * @param scene the scene that is measured
 * @param others scenes to play in between, at least one
 * @param contenders who replays it
 * @param frames of one replay, at least 1
 * @param replays measured ones of each virtual machine, at least 1
 * @param forks virtual machines per contender, at least 1
 * @param warmUpMillis how long each of them plays before its first measured replay
 */
public record ReplayPlan(
    String name,
    Scene scene,
    List<Scene> others,
    List<Contender> contenders,
    int frames,
    int replays,
    int forks,
    int warmUpMillis) {

  /**
   * This library beside the published algorithm; alone where circles collide or fall, or obstacles
   * move, which that one does not know.
   *
   * @param name what to call the scene
   * @param scene the scene that is measured
   * @param others scenes to play in between, at least one
   * @param frames of one replay, at least 1
   * @param forks virtual machines per contender, at least 1
   * @param warmUpMillis how long each of them plays before its first measured replay
   */
  public ReplayPlan(
      String name, Scene scene, List<Scene> others, int frames, int forks, int warmUpMillis) {
    this(
        name,
        scene,
        others,
        PlainScene.collides(scene) || !PlainScene.isStraight(scene) || !PlainScene.isAtRest(scene)
            ? List.of(Methods.CAROM)
            : List.of(Methods.CAROM, Methods.POSTER),
        frames,
        ReplayBenchmark.REPLAYS,
        forks,
        warmUpMillis);
  }

  /** The work of a run, to show its progress: the number of virtual machines it starts. */
  public int steps() {
    return forks * contenders.size();
  }
}
