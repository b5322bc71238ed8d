// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Bounds;
import dev.carom.Feature;
import dev.carom.Kind;
import dev.carom.Scene;

/** One of the four walls of the bounds: 0 left, 1 right, 2 bottom, 3 top. */
final class WallTarget extends Target {

  private final Ball place;

  WallTarget(Scene scene, int index, int bits) {
    super(scene, Kind.WALL, index, bits);
    Bounds b = scene.bounds().orElseThrow();
    double[] places = {b.xmin(), b.xmax(), b.ymin(), b.ymax()};
    place = Ball.of(places[index], bits);
  }

  private boolean isUpper() {
    return index % 2 == 1;
  }

  private boolean isVertical() {
    return index < 2;
  }

  /** With the distance s in front of the wall: {@code t = (s - r) / |v|}, or 0 if s <= r. */
  @Override
  Touch contact(Vec p, Vec v, Ball radius) {
    Ball along = isVertical() ? v.x() : v.y();
    Ball speed = isUpper() ? along : along.negate();
    if (speed.sign() <= 0) {
      return null;
    }
    Ball from = isVertical() ? p.x() : p.y();
    Ball distance = isUpper() ? place.minus(from) : from.minus(place);
    Ball gap = distance.minus(radius);
    boolean overlapping = gap.sign() <= 0;
    Ball after = overlapping ? Ball.of(0, bits) : gap.over(speed);
    return new Touch(after, Feature.SIDE, overlapping);
  }

  /** The distance in front of the wall falls to the radius. */
  @Override
  Touch contact(Fall path, Ball radius, Ball end, Feature touched) {
    Vec wall = isVertical() ? new Vec(place, Ball.of(0, bits)) : new Vec(Ball.of(0, bits), place);
    Ball[] gap = path.height(normal(path.p(), Feature.SIDE), wall, radius);
    return path.contacts(gap, end, touched != null).stream()
        .findFirst()
        .map(after -> new Touch(after, Feature.SIDE, false))
        .orElse(null);
  }

  @Override
  double[] box() {
    double all = Double.POSITIVE_INFINITY;
    return new double[] {-all, -all, all, all};
  }

  @Override
  Vec normal(Vec p, Feature feature) {
    double n = isUpper() ? -1 : 1;
    return isVertical() ? Vec.of(n, 0, bits) : Vec.of(0, n, bits);
  }

  @Override
  boolean isRound(Feature feature) {
    return false;
  }

  /** One component is turned round and scaled by e. */
  @Override
  Vec reflect(Vec v, Vec n, Ball bounce) {
    Ball turned = Ball.of(1, bits).minus(bounce);
    return isVertical() ? new Vec(v.x().times(turned), v.y()) : new Vec(v.x(), v.y().times(turned));
  }

  /** Two of the four are asked at most, so nothing is gained by a better bound. */
  @Override
  double earliest(double x, double y, double vx, double vy, double radius) {
    double along = isVertical() ? vx : vy;
    boolean away = isUpper() ? along < 0 : along > 0;
    return away ? Double.POSITIVE_INFINITY : 0;
  }
}
