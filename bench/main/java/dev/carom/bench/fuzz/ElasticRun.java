// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Scene;
import dev.carom.World;
import java.util.Arrays;

/** An elastic scene of finite masses: what gets through is counted, and energy is compared. */
final class ElasticRun implements Soak.Run {

  /** Steps are so long that one has some hundred impacts. */
  private static final double IMPACTS_PER_STEP = 400;

  private static final int FRAMES_OF_TRIAL = 100;

  private final Scene scene;
  private final World world;
  private final Guard guard;
  private final double[] energies;
  private final double step;
  private long impacts;
  private long escapes;
  private long overlaps;

  ElasticRun(Scene scene) {
    this.scene = scene;
    world = new World(scene);
    guard = new Guard(scene, world);
    energies = energies();
    step = stepLength();
  }

  /** A whole number of frames, found from the impacts of the first ones. */
  private double stepLength() {
    long found = 0;
    World trial = new World(scene);
    for (int frame = 1; frame <= FRAMES_OF_TRIAL; frame++) {
      while (!trial.advanceTo(frame)) {
        found += trial.impacts().size();
      }
      found += trial.impacts().size();
    }
    if (found == 0) {
      throw new IllegalArgumentException(
          "no impact in " + FRAMES_OF_TRIAL + " frames: expected a scene with impacts");
    }
    return Math.max(1, Math.rint(IMPACTS_PER_STEP * FRAMES_OF_TRIAL / found));
  }

  @Override
  public long step() {
    double end = Math.floor(world.now() / step) * step + step;
    long nanos = 0;
    boolean complete;
    do {
      long start = Soak.THREADS.getCurrentThreadCpuTime();
      complete = world.advanceTo(end);
      nanos += Soak.THREADS.getCurrentThreadCpuTime() - start;
      impacts += world.impacts().size();
      guard.watch(world.impacts());
    } while (!complete);
    return nanos;
  }

  @Override
  public void endRound() {
    escapes = Math.max(escapes, guard.outside());
    overlaps = Math.max(overlaps, guard.overlaps());
  }

  @Override
  public long impacts() {
    return impacts;
  }

  @Override
  public double now() {
    return world.now();
  }

  SoakResult result(SoakTimes times) {
    return new SoakResult(times, escapes, guard.crossings(), overlaps, drift());
  }

  private double[] energies() {
    double[] now = new double[world.circleCount()];
    for (int i = 0; i < now.length; i++) {
      now[i] = world.mass(i) / 2 * (world.vx(i) * world.vx(i) + world.vy(i) * world.vy(i));
    }
    return now;
  }

  /** Of all circles together if they collide; else of the worst one. */
  private double drift() {
    double[] now = energies();
    if (scene.collide()) {
      return Arrays.stream(now).sum() / Arrays.stream(energies).sum() - 1;
    }
    double worst = 0;
    for (int i = 0; i < now.length; i++) {
      double change = energies[i] == 0 ? now[i] : now[i] / energies[i] - 1;
      worst = Math.abs(change) > Math.abs(worst) ? change : worst;
    }
    return worst;
  }
}
