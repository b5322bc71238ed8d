// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.peers;

import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import java.util.List;
import java.util.function.BiFunction;

/** The engines, each as it comes and at its best. */
public final class Peers {

  private static final String USUAL = "setting=defaults, 30 px/m";

  private Peers() {}

  /** All of them: each engine twice. */
  public static List<Contender> all() {
    return List.of(
        usual("dyn4j", Dyn4jPeer::new),
        best("dyn4j", "restitution velocity 0, no rest, bullets, no cap, 10+ px/m", Dyn4jPeer::new),
        usual("jbox2d", Jbox2dPeer::new),
        best("jbox2d", "frame 1e-6 s, edge radius 0, no sleep, bullets, 30+ px/m", Jbox2dPeer::new),
        usual("gdx-box2d", GdxPeer::new),
        best("gdx-box2d", "threshold 0, edge radius 0, no sleep, bullets, 10+ px/m", GdxPeer::new));
  }

  private static Contender usual(String label, BiFunction<Scene, Boolean, Method> engine) {
    return new Contender(label + "-defaults", label, USUAL, scene -> engine.apply(scene, false));
  }

  private static Contender best(
      String label, String setting, BiFunction<Scene, Boolean, Method> engine) {
    return new Contender(
        label + "-best", label, "setting=" + setting, scene -> engine.apply(scene, true));
  }
}
