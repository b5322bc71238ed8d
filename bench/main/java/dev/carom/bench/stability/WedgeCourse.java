// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.reference.Reference;

/**
 * The course of one circle between two lines that begin at one point, the second one to the left of
 * the first: {@link WedgeRun}, and its conditioning by runs from starts a little away.
 */
final class WedgeCourse implements Reference {

  private static final int VALUES = 4;

  private final int frames;
  private final double[][] states;
  private final double[] conditioning;
  private final boolean pilesUp;

  WedgeCourse(Scene scene, int frames) {
    this.frames = frames;
    WedgeRun run = run(scene, frames, -1);
    states = run.states();
    pilesUp = run.pilesUp();
    conditioning = new double[frames + 1];
    for (int value = 0; value < VALUES && !pilesUp; value++) {
      run(scene, frames, value).addDistances(run, conditioning);
    }
  }

  private static WedgeRun run(Scene scene, int frames, int nudged) {
    Line first = (Line) scene.shape(Kind.LINE, 0);
    Line second = (Line) scene.shape(Kind.LINE, 1);
    Circle circle = (Circle) scene.shape(Kind.CIRCLE, 0);
    Vec2 velocity = scene.velocity(Kind.CIRCLE, 0);
    double e = scene.traits(Kind.LINE, 0).restitution();
    WedgeRun run = new WedgeRun(first, second, circle.radius(), e);
    run.play(new double[] {circle.x(), circle.y(), velocity.x(), velocity.y()}, nudged, frames);
    return run;
  }

  boolean pilesUp() {
    return pilesUp;
  }

  @Override
  public int frames() {
    return frames;
  }

  @Override
  public int circles() {
    return 1;
  }

  @Override
  public double x(int frame, int circle) {
    return states[frame][0];
  }

  @Override
  public double y(int frame, int circle) {
    return states[frame][1];
  }

  @Override
  public double vx(int frame, int circle) {
    return states[frame][2];
  }

  @Override
  public double vy(int frame, int circle) {
    return states[frame][3];
  }

  @Override
  public double log10Conditioning(int frame, int circle) {
    return Math.log10(conditioning[frame]);
  }
}
