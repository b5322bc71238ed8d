// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.TraitValues;
import dev.carom.internal.util.Check;

/**
 * {@code Traits} are all that a thing is, apart from its shape and its motion. Only circles have a
 * mass other than 1, and only lines are one-way.
 *
 * <pre>{@code
 * final Traits BALL = Traits.DEFAULT.withRestitution(0.9).withMass(2);
 * World world = new World(Scene.builder().bounds(0, 0, 100, 100).build());
 * int ball = world.addCircle(50, 50, 5, 3, 0, BALL);
 * System.out.println(world.traits(Kind.CIRCLE, ball).mass()); // 2.0
 * }</pre>
 *
 * @param restitution finite and at least 0: 1 is elastic, 0 keeps no motion along the normal, above
 *     1 is a bumper. The restitution of an impact is the product of those of the two parties
 * @param mass a number from 2^-500 to 2^500, or infinity: a circle that no other circle deflects,
 *     and that does not fall
 * @param response what happens at an impact with the thing; of a circle, to other circles
 * @param filter what the thing can meet
 * @param oneWay true for a line that is solid only for circles that come from its left, see {@link
 *     SceneBuilder#oneWay()}
 */
public record Traits(
    double restitution, double mass, Response response, Filter filter, boolean oneWay) {

  /** Elastic, of mass 1, bouncing, with the default filter, solid from both sides. */
  public static final Traits DEFAULT = new Traits(1, 1, Response.BOUNCE, Filter.DEFAULT, false);

  /**
   * Checks the components.
   *
   * @param restitution finite and at least 0
   * @param mass a number from 2^-500 to 2^500, or infinity
   * @param response what happens at an impact with the thing
   * @param filter what the thing can meet
   * @param oneWay true for a one-way line
   * @throws IllegalArgumentException if the restitution or the mass is refused
   */
  public Traits {
    Check.notNegative("restitution", restitution);
    Check.mass("mass", mass);
    Check.notNull("response", response);
    Check.notNull("filter", filter);
  }

  static Traits of(ObstacleTable obstacles, int code) {
    return of(obstacles.givenRestitution(code), 1, obstacles.traits(code), obstacles.filter(code));
  }

  static Traits of(CircleRegistry circles, int slot, double restitution) {
    return of(restitution, circles.mass(slot), circles.traits(slot), circles.filter(slot));
  }

  static Traits of(double restitution, double mass, int flags, long filter) {
    Response response = Response.of(ContactFlags.response(flags));
    return new Traits(restitution, mass, response, Filter.of(filter), ContactFlags.isOneWay(flags));
  }

  /** Tells whether these are the traits of given values. */
  boolean are(double itsRestitution, double itsMass, int flags, long bits) {
    return restitution == itsRestitution
        && mass == itsMass
        && response.ordinal() == ContactFlags.response(flags)
        && oneWay == ContactFlags.isOneWay(flags)
        && filter.bits() == bits;
  }

  TraitValues values() {
    int flags = ContactFlags.withOneWay(response.ordinal(), oneWay);
    return new TraitValues(restitution, mass, flags, filter.bits());
  }

  /**
   * Returns the same traits with another restitution.
   *
   * @param restitution finite and at least 0
   * @return traits that differ in the restitution only
   * @throws IllegalArgumentException if it is NaN, infinite or negative
   */
  public Traits withRestitution(double restitution) {
    return new Traits(restitution, mass, response, filter, oneWay);
  }

  /**
   * Returns the same traits with another mass.
   *
   * @param mass a number from 2^-500 to 2^500, or infinity
   * @return traits that differ in the mass only
   * @throws IllegalArgumentException if it is NaN or out of these limits
   */
  public Traits withMass(double mass) {
    return new Traits(restitution, mass, response, filter, oneWay);
  }

  /**
   * Returns the same traits with another response.
   *
   * @param response what happens at an impact with the thing
   * @return traits that differ in the response only
   */
  public Traits withResponse(Response response) {
    return new Traits(restitution, mass, response, filter, oneWay);
  }

  /**
   * Returns the same traits with another filter.
   *
   * @param filter what the thing can meet
   * @return traits that differ in the filter only
   */
  public Traits withFilter(Filter filter) {
    return new Traits(restitution, mass, response, filter, oneWay);
  }

  /**
   * Returns the same traits, of a one-way line or of one that is solid from both sides.
   *
   * @param oneWay true for a line that is solid only for circles that come from its left
   * @return traits that differ in this only
   */
  public Traits withOneWay(boolean oneWay) {
    return new Traits(restitution, mass, response, filter, oneWay);
  }
}
