// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Circle;
import dev.carom.Feature;
import dev.carom.Kind;
import dev.carom.Scene;

/** A circle that stands still. */
final class PegTarget extends Target {

  private final Circle peg;
  private final Vec center;
  private final Ball radius;

  PegTarget(Scene scene, int index, int bits) {
    super(scene, Kind.PEG, index, bits);
    peg = (Circle) scene.shape(Kind.PEG, index);
    center = Vec.of(peg.x(), peg.y(), bits);
    radius = Ball.of(peg.radius(), bits);
  }

  @Override
  Touch contact(Vec p, Vec v, Ball radius) {
    return Disks.contact(p.minus(center), v, radius.plus(this.radius), Feature.CIRCLE, bits);
  }

  /** The distance of the centres falls to the sum of the radii. */
  @Override
  Touch contact(Fall path, Ball radius, Ball end, Feature touched) {
    Ball[] gap = path.distance(center, radius.plus(this.radius));
    return path.contacts(gap, end, touched != null).stream()
        .findFirst()
        .map(after -> new Touch(after, Feature.CIRCLE, false))
        .orElse(null);
  }

  @Override
  double[] box() {
    return new double[] {
      peg.x() - peg.radius(), peg.y() - peg.radius(), peg.x() + peg.radius(), peg.y() + peg.radius()
    };
  }

  @Override
  Vec normal(Vec p, Feature feature) {
    return p.minus(center);
  }

  @Override
  boolean isRound(Feature feature) {
    return true;
  }

  @Override
  double earliest(double x, double y, double vx, double vy, double radius) {
    double extent = Math.abs(x) + Math.abs(y) + Math.abs(peg.x()) + Math.abs(peg.y());
    return Disks.earliest(x - peg.x(), y - peg.y(), vx, vy, radius + peg.radius(), extent);
  }
}
