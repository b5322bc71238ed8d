// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * Collects the things of a {@link Scene}. Each call adds one thing, or gives the thing added last a
 * property. What is refused is refused at once, with a message that names the thing, its number,
 * its value and what was expected, and leaves the builder as it was; only a radius that is too
 * small beside the scene's coordinates is refused by {@link #build}, when all of them are known.
 * Not safe for use by several threads.
 *
 * <pre>{@code
 * Scene scene = Scene.builder()
 *     .bounds(0, 0, 800, 600)
 *     .line(300, 500, 500, 500).oneWay()
 *     .peg(600, 300, 25).response(Response.SENSOR)
 *     .circle(100, 100, 10, 4, 3).mass(2).restitution(0.9)
 *     .collide(true)
 *     .build();
 * System.out.println(scene.oneWay(0) + ", " + scene.mass(0)); // true, 2.0
 * }</pre>
 */
public final class SceneBuilder {

  final SceneThings circles = new SceneThings("circle", Scene.CIRCLE, 2);
  final SceneThings lines = new SceneThings("line", Obstacles.LINE_ROW, 4);
  final SceneThings pegs = new SceneThings("peg", Obstacles.PEG_ROW, 2);
  final SceneThings bounds = new SceneThings("bounds", Scene.BOUNDS, 4);
  final DoubleList masses = new DoubleList();
  boolean collide;

  /** The things whose last one is the thing added last; null before the first. */
  private SceneThings last;

  SceneBuilder() {}

  /**
   * Sets the rectangle that keeps circles inside.
   *
   * @param xmin the x coordinate of the left wall, finite
   * @param ymin the y coordinate of the bottom wall, finite
   * @param xmax the x coordinate of the right wall, finite, greater than xmin
   * @param ymax the y coordinate of the top wall, finite, greater than ymin
   * @return this builder
   * @throws IllegalArgumentException if a coordinate is refused by {@link Bounds}
   * @throws IllegalStateException if the scene has bounds already
   */
  public SceneBuilder bounds(double xmin, double ymin, double xmax, double ymax) {
    if (bounds.count() > 0) {
      throw new IllegalStateException("the scene has bounds already: expected one only");
    }
    return add(bounds, () -> new Bounds(xmin, ymin, xmax, ymax), xmin, ymin, xmax, ymax, 1);
  }

  /**
   * Adds a line from a to b.
   *
   * @param ax the x coordinate of the start, finite
   * @param ay the y coordinate of the start, finite
   * @param bx the x coordinate of the end, finite
   * @param by the y coordinate of the end, finite
   * @return this builder
   * @throws IllegalArgumentException if a coordinate is refused by {@link Line}
   */
  public SceneBuilder line(double ax, double ay, double bx, double by) {
    return add(lines, () -> new Line(ax, ay, bx, by), ax, ay, bx, by, 1);
  }

  /**
   * Adds a peg, a circle that stands still.
   *
   * @param x the x coordinate of the centre, finite
   * @param y the y coordinate of the centre, finite
   * @param radius finite and at least 0
   * @return this builder
   * @throws IllegalArgumentException if a number is refused by {@link Circle}
   */
  public SceneBuilder peg(double x, double y, double radius) {
    return add(pegs, () -> new Circle(x, y, radius), x, y, radius, 1);
  }

  /**
   * Adds a moving circle.
   *
   * @param x the x coordinate of the centre at time 0, finite
   * @param y the y coordinate of the centre at time 0, finite
   * @param radius finite and greater than 0
   * @param vx the x component of the velocity, finite
   * @param vy the y component of the velocity, finite
   * @return this builder
   * @throws IllegalArgumentException if a number is NaN or infinite, or the radius not positive
   */
  public SceneBuilder circle(double x, double y, double radius, double vx, double vy) {
    add(circles, () -> checkCircle(x, y, radius, vx, vy), x, y, radius, vx, vy, 1);
    masses.add(1);
    return this;
  }

  private static void checkCircle(double x, double y, double radius, double vx, double vy) {
    Check.finite("x", x);
    Check.finite("y", y);
    Check.positive("radius", radius);
    Check.finite("vx", vx);
    Check.finite("vy", vy);
  }

  /**
   * Sets the restitution of the thing added last; without it, it is 1. The restitution of an impact
   * is the product of the two parties' restitutions.
   *
   * @param e finite and at least 0: 1 is elastic, 0 keeps no motion along the normal, above 1 is a
   *     bumper
   * @return this builder
   * @throws IllegalArgumentException if e is NaN, infinite or negative
   * @throws IllegalStateException if nothing was added yet
   */
  public SceneBuilder restitution(double e) {
    if (last == null) {
      throw new IllegalStateException("restitution belongs to the thing added last: add one first");
    }
    check(last, last.count() - 1, () -> Check.notNegative("restitution", e));
    last.setLastRestitution(e);
    return this;
  }

  /**
   * Sets what happens at the thing added last; without it, circles bounce.
   *
   * @param response the response; of a circle, to other circles
   * @return this builder
   * @throws IllegalArgumentException if the thing is the bounds and the response {@link
   *     Response#SENSOR}
   * @throws IllegalStateException if nothing was added yet
   */
  public SceneBuilder response(Response response) {
    Check.notNull("response", response);
    if (last == null) {
      throw new IllegalStateException("response belongs to the thing added last: add one first");
    }
    if (last == bounds && response == Response.SENSOR) {
      throw Check.refused("response", "sensor", "bounce or halt: bounds keep circles inside")
          .of("bounds");
    }
    last.setLastTraits(Traits.with(last.lastTraits(), response.ordinal()));
    return this;
  }

  /**
   * Makes the line just added a one-way line. It is solid, ends included, for a flight that starts
   * with the centre strictly left of it (seen from its start to its end, as in {@code cross(b - a,
   * p - a) > 0}) and moves against its left normal; for every other flight it is not there. A line
   * of zero length has no left: it never is.
   *
   * <p><img src="doc-files/one-way.svg" alt="A line from a to b: a circle that comes from its left
   * bounces, one that comes from its right passes" style="max-width:100%">
   *
   * @return this builder
   * @throws IllegalStateException if the thing added last is not a line
   */
  public SceneBuilder oneWay() {
    if (last != lines) {
      throw new IllegalStateException("one-way belongs to the line just added: add one first");
    }
    lines.setLastTraits(Traits.withOneWay(lines.lastTraits(), true));
    return this;
  }

  /**
   * Sets the mass of the circle just added; without it, it is 1. Masses have no effect as long as
   * circles ignore each other.
   *
   * @param m a number from 2^-500 to 2^500, or infinity: a circle that nothing deflects
   * @return this builder
   * @throws IllegalArgumentException if m is NaN or out of these limits
   * @throws IllegalStateException if the thing added last is not a circle
   */
  public SceneBuilder mass(double m) {
    if (last != circles) {
      throw new IllegalStateException("mass belongs to the circle just added: add one first");
    }
    check(circles, circles.count() - 1, () -> Check.mass("mass", m));
    masses.setLast(m);
    return this;
  }

  /**
   * Lets circles collide with each other; without it they ignore each other.
   *
   * @param collide whether they do
   * @return this builder
   */
  public SceneBuilder collide(boolean collide) {
    this.collide = collide;
    return this;
  }

  /**
   * Makes the scene of all that was added. The builder can be used further. Circles may overlap
   * each other and what stands still: {@link Scene#warnings} lists those that do.
   *
   * @return the scene
   * @throws IllegalArgumentException if the radius of a circle is below 2^10 ulps of the largest
   *     coordinate of the scene: rounding of positions could carry such a circle through a line
   */
  public Scene build() {
    int i = firstTooSmall();
    if (i >= 0) {
      String expected =
          "at least %s, 2^10 ulps of the largest coordinate, %s"
              .formatted(leastRadius(), largestCoordinate());
      throw Check.refused("radius", circles.get(i, 2), expected).of(circles.name(i));
    }
    return new Scene(this);
  }

  /** The number of the first circle whose radius keeps the scene from being built, or -1. */
  int firstTooSmall() {
    double least = leastRadius();
    for (int i = 0; i < circles.count(); i++) {
      if (!(circles.get(i, 2) >= least)) {
        return i;
      }
    }
    return -1;
  }

  private double leastRadius() {
    return Limits.leastRadius(largestCoordinate());
  }

  private double largestCoordinate() {
    return Math.max(
        Math.max(circles.largestCoordinate(), lines.largestCoordinate()),
        Math.max(pegs.largestCoordinate(), bounds.largestCoordinate()));
  }

  private SceneBuilder add(SceneThings things, Runnable checks, double... row) {
    check(things, things.count(), checks);
    things.add(row);
    last = things;
    return this;
  }

  /** Puts the name of thing i before what its checks have to say. */
  private static void check(SceneThings things, int i, Runnable checks) {
    try {
      checks.run();
    } catch (RefusedException e) {
      throw e.of(things.name(i));
    }
  }
}
