// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.reference.Reference;
import java.math.BigDecimal;

/**
 * The course of one elastic circle in a rectangle from (0, 0): unfolded it is a straight line,
 * which exact numbers fold back, so that neither the number of impacts nor that of frames costs a
 * digit.
 */
final class BoxCourse implements Reference {

  private final Circle circle;
  private final Vec2 velocity;
  private final double width;
  private final double height;
  private final int frames;

  BoxCourse(Scene scene, double width, double height, int frames) {
    circle = (Circle) scene.shape(Kind.CIRCLE, 0);
    velocity = scene.velocity(Kind.CIRCLE, 0);
    this.width = width;
    this.height = height;
    this.frames = frames;
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
  public double x(int frame, int i) {
    return place(circle.x(), velocity.x(), width, frame);
  }

  @Override
  public double y(int frame, int i) {
    return place(circle.y(), velocity.y(), height, frame);
  }

  /** With u = x - r + v t: it goes to and fro between 0 and the room, once each 2 room. */
  private double place(double x, double v, double side, int frame) {
    BigDecimal radius = new BigDecimal(circle.radius());
    BigDecimal room = new BigDecimal(side).subtract(radius).subtract(radius);
    BigDecimal round = room.add(room);
    BigDecimal way = new BigDecimal(v).multiply(BigDecimal.valueOf(frame));
    BigDecimal u = new BigDecimal(x).subtract(radius).add(way).remainder(round);
    BigDecimal folded = u.signum() < 0 ? u.add(round) : u;
    return folded.min(round.subtract(folded)).add(radius).doubleValue();
  }

  @Override
  public double vx(int frame, int i) {
    return way(circle.x(), velocity.x(), width, frame);
  }

  @Override
  public double vy(int frame, int i) {
    return way(circle.y(), velocity.y(), height, frame);
  }

  /** Turned round after an odd number of impacts. */
  private double way(double x, double v, double side, int frame) {
    BigDecimal radius = new BigDecimal(circle.radius());
    BigDecimal room = new BigDecimal(side).subtract(radius).subtract(radius);
    BigDecimal way = new BigDecimal(v).multiply(BigDecimal.valueOf(frame));
    BigDecimal u = new BigDecimal(x).subtract(radius).add(way);
    BigDecimal lap = u.divideToIntegralValue(room);
    boolean odd = lap.toBigInteger().testBit(0);
    return odd == u.signum() >= 0 ? -v : v;
  }

  /** Flat walls leave an error as it was; so |dx / d ln q| adds up to |x| + |v| t for each axis. */
  @Override
  public double log10Conditioning(int frame, int i) {
    double places = Math.abs(circle.x()) + Math.abs(circle.y());
    double ways = Math.abs(velocity.x()) + Math.abs(velocity.y());
    return Math.log10(places + frame * ways);
  }
}
