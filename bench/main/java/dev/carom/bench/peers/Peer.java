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
 * have it. At its best it gets the scale at which it is most accurate: the coarser its metre, the
 * smaller its tolerances, which are lengths, but the faster its circles, whose motion in a step is
 * capped at 2 m.
 */
abstract class Peer implements Method {

  static final double SECONDS_PER_FRAME = 1.0 / 60;

  /** In px. */
  static final double USUAL_METRE = 30;

  /** In px. */
  final double metre;

  private final double secondsPerFrame;

  Peer(Scene scene, double metre, double secondsPerFrame) {
    PlainScene.check(scene);
    this.metre = metre;
    this.secondsPerFrame = secondsPerFrame;
  }

  /** The least metre, of at least some px, at which the fastest circle moves by no more a frame. */
  static double metreFor(Scene scene, double leastPx, double metresPerFrame) {
    return Math.max(leastPx, fastest(scene) / metresPerFrame);
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
