// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.util.Check;
import dev.carom.internal.util.DoubleList;
import dev.carom.internal.util.KindNumber;
import dev.carom.internal.util.Refusal;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Builds a {@link SceneData}. A bad value is refused at once, with a message that names the thing,
 * and leaves the builder as it was. Only a radius that is too small beside the coordinates of the
 * scene is refused by {@link #build}, when all coordinates are known.
 */
public final class SceneDataBuilder {

  final DoubleList circles = new DoubleList();

  /** The circles without their motion. */
  final CircleRegistry registry;

  ObstacleTable obstacles;
  public boolean collide = true;
  double gx;
  double gy;

  /** The code of the thing added last; that of a wall for the bounds. */
  private int last = MovingCircle.NOTHING;

  /** The velocities of the obstacles that move, by their codes. */
  private final SortedMap<Integer, double[]> velocities = new TreeMap<>();

  public SceneDataBuilder() {
    registry = new CircleRegistry();
    obstacles = ObstacleTable.empty(null);
  }

  /** Begins with all that is in a scene. */
  public SceneDataBuilder(SceneData scene) {
    circles.add(scene.circles);
    registry = scene.registry.copy();
    obstacles = scene.obstacles.copy();
    collide = scene.collide;
    gx = scene.gx;
    gy = scene.gy;
    obstacles
        .codes()
        .filter(obstacles::moves)
        .forEach(k -> velocities.put(k, new double[] {obstacles.ux(k), obstacles.uy(k)}));
  }

  public void bounds(double xmin, double ymin, double xmax, double ymax) {
    if (obstacles.walls != null) {
      throw new IllegalStateException("the scene has bounds already: expected one only");
    }
    check(KindNumber.WALL, 0, () -> Check.bounds(xmin, ymin, xmax, ymax));
    obstacles = obstacles.within(ObstacleTable.walls(xmin, ymin, xmax, ymax));
    last = Codes.LEFT;
  }

  /** Adds an obstacle of a {@link KindNumber}, by the numbers of its shape. */
  public void obstacle(int kind, double... numbers) {
    check(kind, obstacles.end(kind), () -> ObstacleTable.shape(kind).check(numbers));
    last = obstacles.add(kind, numbers);
  }

  /** Adds an outline. */
  public void outline(OutlinePoints outline) {
    check(KindNumber.LINE, obstacles.lines.idLimit(), outline::check);
    last = obstacles.add(outline);
  }

  /** Adds a moving circle of mass 1. */
  public void circle(double x, double y, double radius, double vx, double vy) {
    double r = radius + 0.0; // 0 for -0
    check(KindNumber.CIRCLE, registry.count(), () -> checkCircle(x, y, r, vx, vy));
    circles.add(x, y, r, vx, vy, 1);
    last = Codes.circle(registry.add());
  }

  private static void checkCircle(double x, double y, double radius, double vx, double vy) {
    Check.finite("x", x);
    Check.finite("y", y);
    Check.notNegative("radius", radius);
    Check.finite("vx", vx);
    Check.finite("vy", vy);
  }

  /** The number of things of a {@link KindNumber} so far. */
  public int count(int kind) {
    return kind == KindNumber.CIRCLE ? registry.count() : obstacles.end(kind);
  }

  // Properties of the thing added last.

  public void traits(TraitValues traits) {
    expectThing("traits");
    check(last, () -> traits.check(Codes.kind(last), obstacles.outside(last)));
    if (Codes.isCircle(last)) {
      circles.setLast(traits.restitution());
      traits.set(registry, Codes.slot(last));
    } else {
      traits.set(obstacles, last);
    }
  }

  public void restitution(double e) {
    expectThing("restitution");
    check(last, () -> Check.notNegative("restitution", e));
    if (Codes.isCircle(last)) {
      circles.setLast(e);
    } else {
      obstacles.codesOf(last).forEach(code -> obstacles.setRestitution(code, e));
    }
  }

  /** Sets a response, by its number in {@link ContactFlags}. */
  public void response(int response) {
    expectThing("response");
    check(last, () -> TraitValues.checkResponse(Codes.kind(last), response));
    setTraits(ContactFlags.with(traits(), response));
  }

  private int traits() {
    return Codes.isCircle(last) ? registry.traits(Codes.slot(last)) : obstacles.traits(last);
  }

  private void setTraits(int traits) {
    if (Codes.isCircle(last)) {
      registry.setTraits(Codes.slot(last), traits);
    } else {
      obstacles.codesOf(last).forEach(code -> obstacles.setTraits(code, traits));
    }
  }

  public void filter(int category, int mask) {
    expectThing("filter");
    if (Codes.isCircle(last)) {
      registry.setFilter(Codes.slot(last), FilterBits.of(category, mask));
    } else {
      long filter = FilterBits.of(category, mask);
      obstacles.codesOf(last).forEach(code -> obstacles.setFilter(code, filter));
    }
  }

  private long filter() {
    return Codes.isCircle(last) ? registry.filter(Codes.slot(last)) : obstacles.filter(last);
  }

  /** Sets the category of the thing added last; its mask stays. */
  public void category(int category) {
    filter(category, FilterBits.mask(filter()));
  }

  /** Sets the mask of the thing added last; its category stays. */
  public void mask(int mask) {
    filter(FilterBits.category(filter()), mask);
  }

  private void expectThing(String property) {
    if (last == MovingCircle.NOTHING) {
      throw new IllegalStateException(property + " belongs to the thing added last: add one first");
    }
  }

  public void oneWay() {
    if (!Codes.isLine(last)) {
      throw new IllegalStateException("one-way belongs to the line just added: add one first");
    }
    check(last, () -> TraitValues.checkOneWay("oneway", true, obstacles.outside(last)));
    setTraits(ContactFlags.withOneWay(traits(), true));
  }

  /** Lets the line or the peg just added move with a velocity. */
  public void velocity(double vx, double vy) {
    if (Codes.isWall(last) || Codes.isCircle(last)) {
      throw new IllegalStateException(
          "velocity belongs to the line or peg just added: add one first; that of a circle stands"
              + " in circle(x, y, radius, vx, vy)");
    }
    check(
        last,
        () -> {
          Check.finite("vx", vx);
          Check.finite("vy", vy);
        });
    obstacles.codesOf(last).forEach(code -> setVelocity(code, vx, vy));
  }

  private void setVelocity(int code, double vx, double vy) {
    if (vx == 0 && vy == 0) {
      velocities.remove(code);
    } else {
      velocities.put(code, new double[] {vx, vy});
    }
  }

  public void mass(double m) {
    if (!Codes.isCircle(last)) {
      throw new IllegalStateException("mass belongs to the circle just added: add one first");
    }
    check(last, () -> Check.mass("mass", m));
    registry.setMass(Codes.slot(last), m);
  }

  // The whole.

  /** Sets the acceleration of all circles. A zero has the positive sign. */
  public void gravity(double x, double y) {
    try {
      Check.finite("gx", x);
      Check.finite("gy", y);
    } catch (IllegalArgumentException e) {
      throw Refusal.of("gravity", e);
    }
    gx = x + 0.0; // -0 + 0 is 0
    gy = y + 0.0;
  }

  public SceneData build() {
    SceneData scene = new SceneData(this);
    int i = scene.firstTooSmall();
    if (i >= 0) {
      boolean lines = scene.obstacles.lines.count() > 0;
      check(Codes.circle(i), () -> scene.limits().checkRadius(scene.radius(i), 0, 0, lines));
    }
    return scene;
  }

  /** The number of the first circle whose radius keeps the scene from being built, or -1. */
  public int firstTooSmall() {
    return new SceneData(this).firstTooSmall();
  }

  /** All obstacles so far. */
  ObstacleTable obstacles() {
    obstacles.setMotions(ObstacleMotions.of(velocities));
    obstacles.kinds.forEach(ObstacleRows::trim);
    return obstacles.copy();
  }

  /** Lets a refusal begin with the name of a thing. */
  private static void check(int kind, int i, Runnable checks) {
    try {
      checks.run();
    } catch (IllegalArgumentException e) {
      throw Refusal.of(kind == KindNumber.WALL ? "bounds" : KindNumber.nameOf(kind, i), e);
    }
  }

  private void check(int code, Runnable checks) {
    check(Codes.kind(code), Codes.isCircle(code) ? Codes.slot(code) : obstacles.id(code), checks);
  }
}
