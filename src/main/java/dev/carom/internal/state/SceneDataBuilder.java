// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.util.Check;
import dev.carom.internal.util.DoubleList;
import dev.carom.internal.util.RefusedException;

/**
 * Collects what a {@link SceneData} holds. What is refused is refused at once, with a message that
 * names the thing, and leaves the builder as it was; only a radius that is too small beside the
 * scene's coordinates is refused by {@link #build}, when all of them are known.
 */
public final class SceneDataBuilder {

  /** Doubles of the bounds: xmin, ymin, xmax, ymax, restitution. */
  private static final int BOUNDS_ROW = 5;

  final SceneRows circles = new SceneRows("circle", SceneData.CIRCLE_ROW, 2);
  final SceneRows lines = new SceneRows("line", ObstacleTable.LINE_ROW, 4);
  final SceneRows pegs = new SceneRows("peg", ObstacleTable.PEG_ROW, 2);
  public final SceneRows bounds = new SceneRows("bounds", BOUNDS_ROW, 4);
  final DoubleList masses = new DoubleList();
  public boolean collide;

  /** The things whose last one is the thing added last; null before the first. */
  private SceneRows last;

  public void bounds(double xmin, double ymin, double xmax, double ymax) {
    if (bounds.count() > 0) {
      throw new IllegalStateException("the scene has bounds already: expected one only");
    }
    add(bounds, () -> Check.bounds(xmin, ymin, xmax, ymax), xmin, ymin, xmax, ymax, 1);
  }

  public void line(double ax, double ay, double bx, double by) {
    add(lines, () -> checkLine(ax, ay, bx, by), ax, ay, bx, by, 1);
  }

  private static void checkLine(double ax, double ay, double bx, double by) {
    Check.finite("ax", ax);
    Check.finite("ay", ay);
    Check.finite("bx", bx);
    Check.finite("by", by);
  }

  public void peg(double x, double y, double radius) {
    add(pegs, () -> checkPeg(x, y, radius), x, y, radius, 1);
  }

  private static void checkPeg(double x, double y, double radius) {
    Check.finite("x", x);
    Check.finite("y", y);
    Check.notNegative("radius", radius);
  }

  /** Adds a moving circle of mass 1. */
  public void circle(double x, double y, double radius, double vx, double vy) {
    add(circles, () -> checkCircle(x, y, radius, vx, vy), x, y, radius, vx, vy, 1);
    masses.add(1);
  }

  private static void checkCircle(double x, double y, double radius, double vx, double vy) {
    Check.finite("x", x);
    Check.finite("y", y);
    Check.positive("radius", radius);
    Check.finite("vx", vx);
    Check.finite("vy", vy);
  }

  // Properties of the thing added last.

  public void restitution(double e) {
    if (last == null) {
      throw new IllegalStateException("restitution belongs to the thing added last: add one first");
    }
    check(last, last.count() - 1, () -> Check.notNegative("restitution", e));
    last.setLastRestitution(e);
  }

  /** Sets a response, by its number in {@link ContactFlags}. */
  public void response(int response) {
    if (last == null) {
      throw new IllegalStateException("response belongs to the thing added last: add one first");
    }
    if (last == bounds && response == ContactFlags.SENSOR) {
      throw Check.refused("response", "sensor", "bounce or halt: bounds keep circles inside")
          .of("bounds");
    }
    last.setLastTraits(ContactFlags.with(last.lastTraits(), response));
  }

  public void oneWay() {
    if (last != lines) {
      throw new IllegalStateException("one-way belongs to the line just added: add one first");
    }
    lines.setLastTraits(ContactFlags.withOneWay(lines.lastTraits(), true));
  }

  public void mass(double m) {
    if (last != circles) {
      throw new IllegalStateException("mass belongs to the circle just added: add one first");
    }
    check(circles, circles.count() - 1, () -> Check.mass("mass", m));
    masses.setLast(m);
  }

  // The whole.

  public SceneData build() {
    int i = firstTooSmall();
    if (i >= 0) {
      String expected =
          "at least %s, 2^10 ulps of the largest coordinate, %s"
              .formatted(leastRadius(), largestCoordinate());
      throw Check.refused("radius", radius(i), expected).of(circles.name(i));
    }
    return new SceneData(this);
  }

  /** The number of the first circle whose radius keeps the scene from being built, or -1. */
  public int firstTooSmall() {
    double least = leastRadius();
    for (int i = 0; i < circles.count(); i++) {
      if (!(radius(i) >= least)) {
        return i;
      }
    }
    return -1;
  }

  private double radius(int i) {
    return circles.get(i, SceneData.RADIUS);
  }

  private double leastRadius() {
    return SizeLimits.leastRadius(largestCoordinate());
  }

  private double largestCoordinate() {
    return Math.max(
        Math.max(circles.largestCoordinate(), lines.largestCoordinate()),
        Math.max(pegs.largestCoordinate(), bounds.largestCoordinate()));
  }

  private void add(SceneRows things, Runnable checks, double... row) {
    check(things, things.count(), checks);
    things.add(row);
    last = things;
  }

  /** Puts the name of thing i before what its checks have to say. */
  private static void check(SceneRows things, int i, Runnable checks) {
    try {
      checks.run();
    } catch (RefusedException e) {
      throw e.of(things.name(i));
    }
  }
}
