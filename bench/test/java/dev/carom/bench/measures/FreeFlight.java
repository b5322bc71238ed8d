// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.reference.Reference;

/** The true course of circles that meet nothing. */
record FreeFlight(Scene scene, int frames) implements Reference {

  @Override
  public int circles() {
    return scene.count(Kind.CIRCLE);
  }

  @Override
  public double x(int frame, int circle) {
    return ((Circle) scene.shape(Kind.CIRCLE, circle)).x() + frame * vx(frame, circle);
  }

  @Override
  public double y(int frame, int circle) {
    return ((Circle) scene.shape(Kind.CIRCLE, circle)).y() + frame * vy(frame, circle);
  }

  @Override
  public double vx(int frame, int circle) {
    return scene.velocity(Kind.CIRCLE, circle).x();
  }

  @Override
  public double vy(int frame, int circle) {
    return scene.velocity(Kind.CIRCLE, circle).y();
  }

  @Override
  public double log10Conditioning(int frame, int circle) {
    return Math.log10(1 + frame);
  }
}
