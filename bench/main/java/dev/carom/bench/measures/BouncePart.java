// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.List;

/**
 * How true one contender stays to a ball that bounces elastically on a level floor: the worst error
 * of its energy within ever more bounces.
 *
 * <p>A bounce takes 38.4 frames, so that impacts lie anywhere in a frame. The energy is the mean
 * over one bounce: engines that move in steps gain energy on the way up and lose as much on the way
 * down.
 */
record BouncePart(Contender contender, int bounces) implements Part {

  static final String SCENE = "bounce";
  static final String ENERGY = "bounce_energy";

  private static final double HEIGHT = 23;
  private static final double GRAVITY = 0.125;
  private static final double RADIUS = 10;
  private static final double SECONDS_A_BOUNCE = 2e-6;
  private static final double PEER_SECONDS_A_BOUNCE = 5e-5;

  /** Frames from top to top. */
  private static final double PERIOD = 2 * Math.sqrt(2 * HEIGHT / GRAVITY);

  /** A ball that falls 23 px to the floor; the ceiling is far. */
  static Scene scene() {
    return Scene.builder()
        .bounds(0, 0, 100, 1000)
        .gravity(0, -GRAVITY)
        .circle(50, RADIUS + HEIGHT, RADIUS, 0, 0)
        .build();
  }

  @Override
  public String id() {
    return SCENE + "/ball/" + contender.id();
  }

  @Override
  public double seconds() {
    boolean peer = !contender.knob().isEmpty();
    return Math.max(0.1, bounces * (peer ? PEER_SECONDS_A_BOUNCE : SECONDS_A_BOUNCE));
  }

  @Override
  public List<Row> run() {
    Trial trial = new Trial(SCENE, contender);
    try (Method method = contender.start(scene())) {
      return measure(trial, method, bounces);
    } catch (UnsupportedOperationException | LinkageError e) {
      return List.of(trial.failure(e));
    }
  }

  /** The worst errors within 1, 2, 5, 10, 20, 50 ... bounces. */
  static List<Row> measure(Trial trial, Method method, int bounces) {
    List<Row> rows = new ArrayList<>();
    int next = 1;
    long frame = 0;
    double worst = 0;
    for (int bounce = 1; bounce <= bounces; bounce++) {
      double sum = 0;
      long start = frame;
      for (long end = Math.round(bounce * PERIOD); frame < end; frame++) {
        method.frame();
        double v = method.vy(0);
        sum += v * v / 2 + GRAVITY * (method.y(0) - RADIUS);
      }
      double error = Math.abs(sum / (frame - start) / (GRAVITY * HEIGHT) - 1);
      worst = Double.isNaN(error) ? error : Math.max(worst, error);
      if (bounce == next) {
        rows.add(trial.row(ENERGY, "worst@" + bounce, worst, Trial.ONE, bounce));
        next = after(next);
      }
    }
    return rows;
  }

  private static int after(int n) {
    int power = 1;
    while (10 * power <= n) {
      power *= 10;
    }
    return n == 2 * power ? 5 * power : 2 * n;
  }
}
