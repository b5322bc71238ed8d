// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.SceneDataBuilder;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.KindNumber;

/**
 * A {@code SceneBuilder} collects the things of a {@link Scene}. Each call adds one thing, or gives
 * the thing added last a property.
 *
 * <pre>{@code
 * Scene scene = Scene.builder()
 *     .bounds(0, 0, 800, 600)
 *     .line(300, 500, 500, 500).oneWay()
 *     .peg(600, 300, 25).response(Response.SENSOR)
 *     .circle(100, 100, 10, 4, 3).mass(2).restitution(0.9)
 *     .build();
 * System.out.println(scene.traits(Kind.CIRCLE, 0).mass()); // 2.0
 * }</pre>
 *
 * <p>A call with a wrong value throws at once and leaves the builder as it was. The message names
 * the thing, its number, its value and what was expected. Only a radius that is too small beside
 * the scene's coordinates is refused later, by {@link #build}, when all coordinates are known. Not
 * safe for use by several threads.
 */
public final class SceneBuilder {

  private final SceneDataBuilder data;

  SceneBuilder(SceneDataBuilder data) {
    this.data = data;
  }

  /**
   * Sets the rectangle that keeps circles inside; an infinite coordinate leaves that side open.
   *
   * @param xmin the x coordinate of the left wall, or -infinity
   * @param ymin the y coordinate of the bottom wall, or -infinity
   * @param xmax the x coordinate of the right wall, or +infinity; greater than xmin
   * @param ymax the y coordinate of the top wall, or +infinity; greater than ymin
   * @return this builder
   * @throws IllegalArgumentException if a coordinate is refused by {@link Bounds}
   * @throws IllegalStateException if the scene has bounds already
   */
  public SceneBuilder bounds(double xmin, double ymin, double xmax, double ymax) {
    data.bounds(xmin, ymin, xmax, ymax);
    return this;
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
    data.obstacle(KindNumber.LINE, ax, ay, bx, by);
    return this;
  }

  /**
   * Adds an outline: joined lines with one id, of the kind {@link Kind#LINE}. It rests unless
   * {@link #velocity velocity} is called.
   *
   * @param outline a polyline or a solid polygon
   * @return this builder
   */
  public SceneBuilder outline(Outline outline) {
    data.outline(Check.notNull("outline", outline).values());
    return this;
  }

  /**
   * Adds a peg: a round obstacle. It rests unless {@link #velocity velocity} is called.
   *
   * @param x the x coordinate of the centre, finite
   * @param y the y coordinate of the centre, finite
   * @param radius finite and at least 0
   * @return this builder
   * @throws IllegalArgumentException if a number is refused by {@link Circle}
   */
  public SceneBuilder peg(double x, double y, double radius) {
    data.obstacle(KindNumber.PEG, x, y, radius);
    return this;
  }

  /**
   * Adds a moving circle.
   *
   * @param x the x coordinate of the centre at time 0, finite
   * @param y the y coordinate of the centre at time 0, finite
   * @param radius finite and at least 0; a circle of radius 0 is a point particle. See also {@link
   *     #build}
   * @param vx the x component of the velocity, finite
   * @param vy the y component of the velocity, finite
   * @return this builder
   * @throws IllegalArgumentException if a number is NaN or infinite, or the radius negative
   */
  public SceneBuilder circle(double x, double y, double radius, double vx, double vy) {
    data.circle(x, y, radius, vx, vy);
    return this;
  }

  /**
   * Sets the restitution of the thing added last; without it, it is 1. The restitution of an impact
   * is the product of those of the two parties.
   *
   * @param e finite and at least 0: 1 is elastic, 0 keeps no motion along the normal, above 1 is a
   *     bumper
   * @return this builder
   * @throws IllegalArgumentException if e is NaN, infinite or negative
   * @throws IllegalStateException if nothing was added yet
   */
  public SceneBuilder restitution(double e) {
    data.restitution(e);
    return this;
  }

  /**
   * Sets the response of the thing added last: what happens at an impact with it. Without it,
   * circles bounce.
   *
   * @param response the response; of a circle, to other circles
   * @return this builder
   * @throws IllegalArgumentException if the thing is the bounds and the response {@link
   *     Response#SENSOR}
   * @throws IllegalStateException if nothing was added yet
   */
  public SceneBuilder response(Response response) {
    data.response(Check.notNull("response", response).ordinal());
    return this;
  }

  /**
   * Sets what the thing added last can meet. Without it, it is {@link Filter#DEFAULT}.
   *
   * @param filter its category and its mask
   * @return this builder
   * @throws IllegalStateException if nothing was added yet
   */
  public SceneBuilder filter(Filter filter) {
    Check.notNull("filter", filter);
    data.filter(filter.category(), filter.mask());
    return this;
  }

  /**
   * Sets all traits of the thing added last. Without it, they are {@link Traits#DEFAULT}.
   *
   * @param traits its restitution, mass, response and filter, and whether it is a one-way line
   * @return this builder
   * @throws IllegalArgumentException if a thing of its kind cannot have them: a mass other than 1
   *     is of circles only, one-way of lines only, and the bounds cannot be a sensor
   * @throws IllegalStateException if nothing was added yet
   */
  public SceneBuilder traits(Traits traits) {
    data.traits(Check.notNull("traits", traits).values());
    return this;
  }

  /**
   * Makes the line just added a one-way line: circles that come from its left bounce, all others
   * pass.
   *
   * <p>Left is as seen from the start of the line to its end, as in {@code cross(b - a, p - a) >
   * 0}. The line is solid, ends included, for a flight that starts with the centre strictly left of
   * it and moves against its left normal. For every other flight it does not exist. Under gravity,
   * a flight can turn: there the place and the motion count with which it comes to touch the line.
   * A line of zero length has no left, so no circle ever hits it.
   *
   * <p><img src="doc-files/one-way.svg" alt="A line from a to b: a circle that comes from its left
   * bounces, one that comes from its right passes" style="max-width:100%">
   *
   * @return this builder
   * @throws IllegalStateException if the thing added last is not a line
   */
  public SceneBuilder oneWay() {
    data.oneWay();
    return this;
  }

  /**
   * Lets the line or the peg just added move with a constant velocity; without it, it rests.
   *
   * <p>Nothing deflects it, and it pushes the circles in its way: see {@link
   * World#setVelocity(Kind, int, double, double) World.setVelocity}.
   *
   * @param vx the x component, finite
   * @param vy the y component, finite
   * @return this builder
   * @throws IllegalArgumentException if a component is NaN or infinite
   * @throws IllegalStateException if the thing added last is neither a line nor a peg
   */
  public SceneBuilder velocity(double vx, double vy) {
    data.velocity(vx, vy);
    return this;
  }

  /**
   * Sets the mass of the circle just added; without it, it is 1. As long as circles ignore each
   * other, masses have no effect, except that {@link #gravity} spares a circle of infinite mass.
   *
   * @param m a number from 2^-500 to 2^500, or infinity: a circle that no other circle deflects
   * @return this builder
   * @throws IllegalArgumentException if m is NaN or out of these limits
   * @throws IllegalStateException if the thing added last is not a circle
   */
  public SceneBuilder mass(double m) {
    data.mass(m);
    return this;
  }

  /**
   * Sets whether circles collide with each other; without this call they do. Circles that ignore
   * each other cost less: see <a href="package-summary.html">how the time grows</a>.
   *
   * @param collide true if they collide
   * @return this builder
   */
  public SceneBuilder collide(boolean collide) {
    data.collide = collide;
    return this;
  }

  /**
   * Sets the gravity: one constant acceleration of all circles of finite mass. Without it, circles
   * fly straight. Down is {@code (0, -g)} if y points up, and {@code (0, g)} if y points down.
   *
   * <p>Its unit is a length per time squared, in the units of the scene. With 30 px to the metre
   * and 60 frames to the second, 9.81 m/s^2 are {@code 9.81 * 30 / (60 * 60)} px per frame squared.
   *
   * <p>All circles of finite mass fall alike. One of infinite mass does not fall, even where
   * circles ignore each other. Neither do lines, pegs and bounds.
   *
   * <p>Gravity (0, 0) is none. The world then runs the same code as without this call, and gives
   * the same bits.
   *
   * <pre>{@code
   * Scene scene = Scene.builder()
   *     .bounds(0, 0, 100, 100)
   *     .circle(50, 80, 5, 1, 0).restitution(0.8)
   *     .gravity(0, -0.5) // towards the bottom wall, at y = 0
   *     .build();
   * System.out.println(scene.gravity()); // Vec2[x=0.0, y=-0.5]
   * }</pre>
   *
   * @param gx the x component, finite
   * @param gy the y component, finite
   * @return this builder
   * @throws IllegalArgumentException if a component is NaN or infinite
   */
  public SceneBuilder gravity(double gx, double gy) {
    data.gravity(gx, gy);
    return this;
  }

  /**
   * Returns the number of things of a kind that were added: the number of the next one.
   *
   * @param kind their kind
   * @return at least 0
   */
  public int count(Kind kind) {
    return data.count(Check.notNull("kind", kind).ordinal());
  }

  /**
   * Makes the scene of all that was added. The builder can be used further.
   *
   * <p>Circles may overlap each other and obstacles: {@link Scene#warnings} lists those that do.
   *
   * @return the scene
   * @throws IllegalArgumentException if the radius of a circle is below 2^10 ulps of the largest
   *     coordinate of the scene: rounding of positions could carry such a circle through a line. A
   *     radius of 0 is refused only in a scene with lines
   */
  public Scene build() {
    return new Scene(data.build());
  }
}
