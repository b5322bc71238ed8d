// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.peers;

import dev.carom.Bounds;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.bench.methods.Method;
import dev.carom.bench.methods.PlainScene;
import java.util.ArrayList;
import java.util.List;

/**
 * What all engines share: they measure in metres and seconds, so that a scene has to be scaled, and
 * they do not tell their work.
 *
 * <p>As it comes, an engine gets 30 px to the metre and 60 frames to the second, as their tutorials
 * have it. At its best, the scale is as fine as it may be for no circle to reach the engine's cap
 * on the motion of one step, 2 m, nor go far below it: 10 px to the metre, or more if the fastest
 * circle would else make more than 1.6 m in a frame.
 */
abstract class Peer implements Method {

  static final double SECONDS_PER_FRAME = 1.0 / 60;

  private static final double USUAL_SCALE = 30;
  private static final double BEST_SCALE = 10;
  private static final double METRES_PER_FRAME = 1.6;

  /** In px. */
  final double metre;

  private final double secondsPerFrame;

  Peer(Scene scene, boolean best, double secondsPerFrame) {
    PlainScene.check(scene);
    this.secondsPerFrame = secondsPerFrame;
    metre = best ? Math.max(BEST_SCALE, fastest(scene) / METRES_PER_FRAME) : USUAL_SCALE;
  }

  private static double fastest(Scene scene) {
    double fastest = 0;
    for (int i = 0; i < scene.circleCount(); i++) {
      fastest = Math.max(fastest, scene.velocity(i).length());
    }
    return fastest;
  }

  /** The lines, and the four walls as lines. */
  static List<Line> edges(Scene scene) {
    List<Line> edges = new ArrayList<>();
    for (int k = 0; k < scene.lineCount(); k++) {
      edges.add(scene.line(k));
    }
    if (scene.bounds().isPresent()) {
      Bounds b = scene.bounds().get();
      edges.add(new Line(b.xmin(), b.ymin(), b.xmax(), b.ymin()));
      edges.add(new Line(b.xmax(), b.ymin(), b.xmax(), b.ymax()));
      edges.add(new Line(b.xmax(), b.ymax(), b.xmin(), b.ymax()));
      edges.add(new Line(b.xmin(), b.ymax(), b.xmin(), b.ymin()));
    }
    return edges;
  }

  final double metres(double px) {
    return px / metre;
  }

  final double metresPerSecond(double pxPerFrame) {
    return pxPerFrame / metre / secondsPerFrame;
  }

  final double px(double metres) {
    return metres * metre;
  }

  final double pxPerFrame(double metresPerSecond) {
    return metresPerSecond * secondsPerFrame * metre;
  }

  @Override
  public final int impacts() {
    return UNKNOWN;
  }

  @Override
  public final int wallImpacts() {
    return UNKNOWN;
  }

  @Override
  public final int squareRoots() {
    return UNKNOWN;
  }

  @Override
  public final long pairTests() {
    return UNKNOWN;
  }

  @Override
  public final long fallbacks() {
    return UNKNOWN;
  }
}
