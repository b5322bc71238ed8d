// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Kind;
import dev.carom.Outline;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import java.util.Random;

/** The scene from which a session starts. */
final class SessionScene {

  /** Lines, at most: about as many as make a grid pay, and many more. */
  private static final int FEW = 12;

  private static final int CROWD = 100;

  private final Random random;
  private final Numbers numbers;
  private final Filters filters;
  private final Falls falls;
  private final Variation variation;
  private final SceneBuilder builder = Scene.builder();

  /** Half of all scenes are elastic throughout, so that energy can be looked at. */
  private final boolean elastic;

  /** Few scenes have bumpers: they lead to more and more impacts, which takes long. */
  private final boolean bumpers;

  private final boolean traits;
  private final boolean masses;
  private final boolean crowded;

  /** Null where obstacles rest. */
  private final Motions motions;

  /** The number of outlines. */
  private final int outlines;

  SessionScene(
      Random random,
      Numbers numbers,
      Filters filters,
      Falls falls,
      Variation variation,
      boolean crowded,
      Motions motions,
      int outlines) {
    this.random = random;
    this.numbers = numbers;
    this.filters = filters;
    this.falls = falls;
    this.variation = variation;
    elastic = random.nextBoolean();
    bumpers = random.nextInt(6) == 0;
    traits = random.nextBoolean();
    masses = random.nextBoolean();
    this.crowded = crowded;
    this.motions = motions;
    this.outlines = outlines;
  }

  boolean hasTraits() {
    return traits;
  }

  Scene build() {
    builder.collide(random.nextBoolean());
    falls.begin(builder);
    if (random.nextInt(5) > 0) {
      builder.bounds(0, 0, numbers.width(), numbers.height());
      builder.restitution(restitution());
      filters.draw(builder);
    }
    int lines = random.nextInt(crowded ? CROWD : FEW);
    for (int i = 0; i < lines; i++) {
      addLine();
      builder.restitution(restitution());
      builder.response(response(Kind.LINE));
      if (traits && random.nextInt(4) == 0) {
        builder.oneWay();
      }
      filters.draw(builder);
      move();
    }
    addOutlines();
    int pegs = random.nextInt(4);
    for (int i = 0; i < pegs; i++) {
      double x = numbers.x();
      double y = numbers.y();
      variation.centre(x, y);
      builder.peg(x, y, numbers.pegRadius()).restitution(restitution());
      builder.response(response(Kind.PEG));
      filters.draw(builder);
      move();
    }
    addCircles();
    return builder.build();
  }

  private void move() {
    if (motions != null) {
      motions.begin(builder);
    }
  }

  /** In a crowd a short one: long ones would leave no room. */
  private void addLine() {
    double x = numbers.x();
    double y = numbers.y();
    variation.centre(x, y);
    if (crowded) {
      builder.line(x, y, x + numbers.step(), y + numbers.step());
    } else {
      builder.line(x, y, numbers.x(), numbers.y());
    }
  }

  private void addOutlines() {
    for (int i = 0; i < outlines; i++) {
      double x = numbers.x();
      double y = numbers.y();
      double size = (1 + random.nextInt(3)) * numbers.length();
      builder.outline(random.nextInt(3) == 0 ? polyline(x, y, size) : polygon(x, y, size));
      builder.restitution(restitution()).response(response(Kind.LINE));
      filters.draw(builder);
      move();
    }
  }

  /** With joints of any angle, some of them level, and perhaps closed. */
  private Outline polyline(double x, double y, double size) {
    double[] xy = new double[2 * (3 + random.nextInt(4))];
    for (int k = 0; k < xy.length; k += 2) {
      xy[k] = x + k * size / 4;
      xy[k + 1] = y + random.nextInt(3) * size / 2;
    }
    if (random.nextBoolean()) {
      xy[xy.length - 2] = xy[0];
      xy[xy.length - 1] = xy[1];
    }
    return Outline.polyline(xy);
  }

  /** A rectangle, or a star of round or of any coordinates, in either direction. */
  private Outline polygon(double x, double y, double size) {
    if (random.nextInt(3) == 0) {
      return Outline.rectangle(x, y, x + size, y + (1 + random.nextInt(2)) * size / 2);
    }
    int n = 3 + random.nextInt(6);
    double way = random.nextBoolean() ? 1 : -1;
    boolean round = random.nextBoolean();
    double[] xy = new double[2 * n];
    for (int i = 0; i < n; i++) {
      double angle = 2 * Math.PI * (i + 0.3 * random.nextDouble()) / n * way;
      double radius = size * (0.3 + random.nextDouble());
      double unit = round ? size / 64 : size / 0x1p30;
      xy[2 * i] = x + Math.rint(radius * Math.cos(angle) / unit) * unit;
      xy[2 * i + 1] = y + Math.rint(radius * Math.sin(angle) / unit) * unit;
    }
    return Outline.polygon(xy);
  }

  private void addCircles() {
    int circles = 1 + random.nextInt(8);
    for (int i = 0; i < circles; i++) {
      double r = numbers.radius();
      Vec2 place = variation.place(numbers.x(), numbers.y());
      builder.circle(place.x(), place.y(), r, numbers.speed(), numbers.speed());
      builder.restitution(restitution());
      builder.response(response(Kind.CIRCLE));
      if (masses) {
        builder.mass(numbers.mass());
      }
      filters.draw(builder);
    }
  }

  /** For the thing in hand. */
  double restitution() {
    double[] some = {0, 0.5, 0.9, 1, 1, 1, 1, bumpers ? 1.1 : 1};
    return elastic ? 1 : some[random.nextInt(some.length)];
  }

  Response response(Kind kind) {
    if (!traits || random.nextInt(3) > 0) {
      return Response.BOUNCE;
    }
    boolean noSensor = kind == Kind.WALL;
    Response drawn = Response.values()[random.nextInt(noSensor ? 2 : 3)];
    return elastic && drawn == Response.HALT ? Response.BOUNCE : drawn;
  }
}
