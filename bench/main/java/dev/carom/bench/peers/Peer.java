// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.peers;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Traits;
import dev.carom.Vec2;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.methods.Method;
import dev.carom.bench.methods.PlainScene;
import java.util.ArrayList;
import java.util.List;

/**
 * Facts that all engines share: they measure in metres and seconds, so that a scene has to be
 * scaled, and they do not tell their work.
 *
 * <p>As it comes, an engine gets 30 px to the metre and 60 frames to the second, as their tutorials
 * have it. At its best it gets the scale at which it is most accurate: the coarser its metre, the
 * smaller its tolerances, which are lengths, but the faster its circles, whose motion in a step is
 * capped at 2 m.
 *
 * <p>Of two things that touch, all of them take the greater restitution, where a scene takes the
 * product: obstacles get the product, and circles that of two circles, or 0 if they do not collide.
 *
 * <p>Under gravity all of them change the velocity by {@code g h} at the beginning of a step of
 * length h, so a circle in free fall is ahead by {@code g t h / 2} after a time t.
 */
abstract class Peer implements Method {

  static final double SECONDS_PER_FRAME = 1.0 / 60;

  /** In px. */
  static final double USUAL_METRE = 30;

  /** In px. */
  private final double metre;

  final boolean best;

  /** In m/s^2. */
  final Vec2 gravity;

  private final double secondsPerFrame;

  Peer(Scene scene, boolean best, double metre, double secondsPerFrame) {
    PlainScene.checkObstacles(scene);
    checkRestitution(scene);
    this.best = best;
    this.metre = metre;
    this.secondsPerFrame = secondsPerFrame;
    Vec2 g = scene.gravity();
    gravity =
        new Vec2(
            metresPerSecond(g.x()) / secondsPerFrame, metresPerSecond(g.y()) / secondsPerFrame);
  }

  /**
   * The least metre, of at least some px, at which the fastest circle moves by no more a frame.
   * Where it falls without bounds, that is so at the start only.
   */
  static double metreFor(Scene scene, double leastPx, double metresPerFrame) {
    return Math.max(leastPx, fastest(scene) / metresPerFrame);
  }

  private static void checkRestitution(Scene scene) {
    double least = scene.bounds().isPresent() ? scene.traits(Kind.WALL, 0).restitution() : 1;
    for (int k = 0; k < scene.count(Kind.LINE); k++) {
      least = Math.min(least, scene.traits(Kind.LINE, k).restitution());
    }
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      double e = scene.traits(Kind.CIRCLE, i).restitution();
      if (e != scene.traits(Kind.CIRCLE, 0).restitution() || (scene.collide() && e > least)) {
        throw new UnsupportedOperationException(
            "the engine takes the greater of two restitutions, not the product: expected circles"
                + " with the same one, and no obstacle with less where circles collide");
      }
    }
  }

  private static double fastest(Scene scene) {
    return Math.hypot(SceneDrawing.fastest(scene), Math.sqrt(2 * deepestFall(scene)));
  }

  /** The energy of a unit of mass that falls from one corner of the bounds to the other. */
  private static double deepestFall(Scene scene) {
    Vec2 g = scene.gravity();
    return scene
        .bounds()
        .map(b -> Math.abs(g.x()) * (b.xmax() - b.xmin()) + Math.abs(g.y()) * (b.ymax() - b.ymin()))
        .orElse(0.0);
  }

  /** Both Box2Ds turn an infinite mass into a NaN. Their largest mass is as hard to move. */
  static float finiteMass(double mass) {
    return (float) Math.min(mass, Float.MAX_VALUE);
  }

  /** A line in metres, and the restitution of its fixture. */
  record Edge(Line line, double restitution) {}

  /**
   * A circle in metres and seconds.
   *
   * @param mass NaN where circles do not collide, and it does not matter
   * @param falls whether gravity acts on it, also where circles ignore each other
   * @param restitution of its fixture
   */
  record Ball(
      double x,
      double y,
      double radius,
      double vx,
      double vy,
      double mass,
      boolean falls,
      double restitution) {}

  final List<Ball> balls(Scene scene) {
    List<Ball> balls = new ArrayList<>();
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      Circle c = (Circle) scene.shape(Kind.CIRCLE, i);
      Vec2 v = scene.velocity(Kind.CIRCLE, i);
      Traits traits = scene.traits(Kind.CIRCLE, i);
      balls.add(
          new Ball(
              metres(c.x()),
              metres(c.y()),
              metres(c.radius()),
              metresPerSecond(v.x()),
              metresPerSecond(v.y()),
              scene.collide() ? traits.mass() : Double.NaN,
              traits.mass() < Double.POSITIVE_INFINITY,
              scene.collide() ? traits.restitution() * traits.restitution() : 0));
    }
    return balls;
  }

  /** The lines, and the four walls as lines. */
  final List<Edge> edges(Scene scene) {
    List<Edge> edges = new ArrayList<>();
    double circles = scene.count(Kind.CIRCLE) == 0 ? 1 : scene.traits(Kind.CIRCLE, 0).restitution();
    for (int k = 0; k < scene.count(Kind.LINE); k++) {
      edges.add(
          edge(
              (Line) scene.shape(Kind.LINE, k),
              circles * scene.traits(Kind.LINE, k).restitution()));
    }
    if (scene.bounds().isPresent()) {
      Bounds b = scene.bounds().get();
      double e = circles * scene.traits(Kind.WALL, 0).restitution();
      edges.add(edge(new Line(b.xmin(), b.ymin(), b.xmax(), b.ymin()), e));
      edges.add(edge(new Line(b.xmax(), b.ymin(), b.xmax(), b.ymax()), e));
      edges.add(edge(new Line(b.xmax(), b.ymax(), b.xmin(), b.ymax()), e));
      edges.add(edge(new Line(b.xmin(), b.ymax(), b.xmin(), b.ymin()), e));
    }
    return edges;
  }

  private Edge edge(Line l, double restitution) {
    return new Edge(
        new Line(metres(l.ax()), metres(l.ay()), metres(l.bx()), metres(l.by())), restitution);
  }

  private double metres(double px) {
    return px / metre;
  }

  private double metresPerSecond(double pxPerFrame) {
    return pxPerFrame / metre / secondsPerFrame;
  }

  final double px(double metres) {
    return metres * metre;
  }

  final double pxPerFrame(double metresPerSecond) {
    return metresPerSecond * secondsPerFrame * metre;
  }

  @Override
  public final long fallbacks() {
    return UNKNOWN;
  }
}
