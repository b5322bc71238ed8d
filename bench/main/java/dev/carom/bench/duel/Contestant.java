// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.duel;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.measures.SolidScene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.methods.PlainScene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;

/**
 * A method that plays a scene on demand. Its frames are kept, so that it can be rewound; of a long
 * run the oldest ones are dropped. From the frame on in which it fails it stands still.
 */
final class Contestant implements AutoCloseable {

  /** Numbers that are kept, of all frames: 64 MB. */
  private static final int NUMBERS = 8_000_000;

  /** Frames whose median time is told: a second. */
  private static final int WINDOW = 60;

  /**
   * Frames that are played at a time: between two drawings a single one would find the caches of
   * the processor empty, and its time would tell of that.
   */
  private static final int BATCH = 16;

  private static final int STATE = 4;
  private static final double NANOS_A_MICRO = 1e3;

  private final Scene scene;
  private final SolidScene solid;
  private final List<PlayedFrame> frames = new ArrayList<>();
  private final long[] nanos = new long[WINDOW];
  private final int kept;
  private final double energyAtStart;
  private Method method;
  private int dropped;
  private String failure;

  Contestant(Contender contender, Scene scene) {
    this.scene = scene;
    solid = new SolidScene(scene);
    kept = Math.max(WINDOW, NUMBERS / Math.max(1, STATE * scene.count(Kind.CIRCLE)));
    double[] states = new double[STATE * scene.count(Kind.CIRCLE)];
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      states[STATE * i] = ((Circle) scene.shape(Kind.CIRCLE, i)).x();
      states[STATE * i + 1] = ((Circle) scene.shape(Kind.CIRCLE, i)).y();
      states[STATE * i + 2] = scene.velocity(Kind.CIRCLE, i).x();
      states[STATE * i + 3] = scene.velocity(Kind.CIRCLE, i).y();
    }
    energyAtStart = energy(states);
    double energy = energyAtStart > 0 ? 1 : Double.NaN;
    frames.add(new PlayedFrame(states, new BitSet(), 0, energy, Double.NaN));
    try {
      method = contender.start(scene);
    } catch (UnsupportedOperationException | IllegalArgumentException e) {
      failure = e.getMessage();
    }
  }

  /** Why it cannot play, or no longer at a frame. */
  Optional<String> failure(int frame) {
    boolean plays = method != null && frame <= last();
    return plays ? Optional.empty() : Optional.ofNullable(failure);
  }

  /** The number of the last frame that was played. */
  private int last() {
    return dropped + frames.size() - 1;
  }

  /** The state at the end of a frame, 0 for the start; it is played if need be. */
  PlayedFrame at(int frame) {
    if (last() < frame) {
      int end = Math.max(frame, last() + BATCH);
      while (last() < end && failure == null) {
        play();
      }
    }
    return frames.get(Math.max(0, Math.min(frame, last()) - dropped));
  }

  private void play() {
    long start = System.nanoTime();
    try {
      method.frame();
    } catch (IllegalStateException | ArithmeticException | IndexOutOfBoundsException e) {
      failure = "frame " + (last() + 1) + ": " + e.getMessage();
      return;
    }
    nanos[last() % WINDOW] = System.nanoTime() - start;
    frames.add(judged(frames.get(frames.size() - 1)));
    if (frames.size() > 2 * kept) {
      frames.subList(0, kept).clear();
      dropped += kept;
    }
  }

  private PlayedFrame judged(PlayedFrame before) {
    int n = scene.count(Kind.CIRCLE);
    double[] states = new double[STATE * n];
    for (int i = 0; i < n; i++) {
      states[STATE * i] = method.x(i);
      states[STATE * i + 1] = method.y(i);
      states[STATE * i + 2] = method.vx(i);
      states[STATE * i + 3] = method.vy(i);
    }
    BitSet lost = before.lostCircles();
    double penetration = before.penetration();
    for (int i = 0; i < n; i++) {
      if (!lost.get(i) && isLost(before, states, i)) {
        lost.set(i);
      }
    }
    for (int i = 0; i < n; i++) {
      if (!lost.get(i)) {
        double depth = solid.depth(states[STATE * i], states[STATE * i + 1], i);
        penetration = Math.max(penetration, Math.max(depth, depthInOthers(states, lost, i)));
      }
    }
    return new PlayedFrame(states, lost, penetration, energy(states) / energyAtStart, micros());
  }

  private boolean isLost(PlayedFrame before, double[] states, int i) {
    double x = states[STATE * i];
    double y = states[STATE * i + 1];
    if (!Double.isFinite(x) || !Double.isFinite(y) || !solid.isInside(x, y)) {
      return true;
    }
    double speed =
        Math.max(
            Math.hypot(before.vx(i), before.vy(i)),
            Math.hypot(states[STATE * i + 2], states[STATE * i + 3]));
    // Under gravity it may have been faster in between, at a bounce.
    return solid.passes(before.x(i), before.y(i), x, y, speed + scene.gravity().length());
  }

  /** The deepest overlap of a circle with those after it, in its own radii. */
  private double depthInOthers(double[] states, BitSet lost, int i) {
    double deepest = 0;
    for (int j = i + 1; scene.collide() && j < scene.count(Kind.CIRCLE); j++) {
      if (!lost.get(j)) {
        double distance =
            Math.hypot(
                states[STATE * i] - states[STATE * j],
                states[STATE * i + 1] - states[STATE * j + 1]);
        double reach =
            ((Circle) scene.shape(Kind.CIRCLE, i)).radius()
                + ((Circle) scene.shape(Kind.CIRCLE, j)).radius();
        deepest =
            Math.max(deepest, (reach - distance) / ((Circle) scene.shape(Kind.CIRCLE, i)).radius());
      }
    }
    return deepest;
  }

  private double energy(double[] states) {
    double sum = 0;
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      double vx = states[STATE * i + 2];
      double vy = states[STATE * i + 3];
      if (scene.traits(Kind.CIRCLE, i).mass() < Double.POSITIVE_INFINITY) {
        double fall = fall(states[STATE * i], states[STATE * i + 1], i);
        sum += scene.traits(Kind.CIRCLE, i).mass() * (vx * vx + vy * vy + 2 * fall);
      }
    }
    return sum;
  }

  /** The energy of a unit of mass that falls from a place as low as the bounds let circle i. */
  private double fall(double x, double y, int i) {
    if (PlainScene.isStraight(scene)) {
      return 0;
    }
    if (scene.bounds().isEmpty()) {
      return Double.NaN;
    }
    Bounds b = scene.bounds().get();
    Vec2 g = scene.gravity();
    double r = ((Circle) scene.shape(Kind.CIRCLE, i)).radius();
    double lowX = g.x() > 0 ? b.xmax() - r : b.xmin() + r;
    double lowY = g.y() > 0 ? b.ymax() - r : b.ymin() + r;
    return g.x() * (lowX - x) + g.y() * (lowY - y);
  }

  /** The median: the virtual machine's own pauses are no part of it. */
  private double micros() {
    long[] sorted = Arrays.copyOf(nanos, Math.min(WINDOW, last() + 1));
    Arrays.sort(sorted);
    return sorted[sorted.length / 2] / NANOS_A_MICRO;
  }

  @Override
  public void close() {
    if (method != null) {
      method.close();
    }
  }
}
