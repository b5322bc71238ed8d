// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.util.Check;

/**
 * An {@code Impact} is the contact of a moving circle with an obstacle or with another circle. It
 * is a row of an {@link ImpactLog}, or the answer of a cast or a trace. Its constructor checks
 * nothing.
 *
 * @param time the time of impact: in a log on the world's clock, else counted from the start of the
 *     motion
 * @param circle the id of the circle, see {@link ImpactLog#circle}; -1 if it is none of a world, as
 *     in the answer of a cast
 * @param kind the kind of thing that was hit
 * @param id the id of the thing that was hit. From a {@link Resolver} it is the place in the list
 *     of its kind that the resolver was made of. For a wall it is 0 left, 1 right, 2 bottom, 3 top.
 *     From the detector alone it is -1, except for walls
 * @param part of an {@link Outline} the number of the side that was hit, see {@link Outline#side};
 *     of all else 0. A vertex is the {@link Feature#START} of the side that begins there; only the
 *     last point of a polyline, where none begins, is the {@link Feature#END} of the last side
 * @param feature the feature that was hit
 * @param x the x coordinate of the contact point, on the thing that was hit; of two circles that of
 *     the point where they touch. If they overlap at the start, the point is that of the line or
 *     wall that is nearest to the centre; of a peg or another circle it divides the distance of the
 *     centres in the ratio of the radii. A coordinate beyond the range of doubles is the largest
 *     one
 * @param y the y coordinate of the contact point
 * @param nx the x component of the unit normal, which points from the thing that was hit to the
 *     circle (of two circles of a world: from {@code id} to {@code circle}); in the answer of a
 *     cast it is within 1e-15 of the true one
 * @param ny the y component of the unit normal
 * @param approachSpeed the speed at which the distance falls at contact: {@code -(v - u).n}, with
 *     the velocity v of the circle and u of the thing that was hit. In the answer of a cast it is
 *     greater than 0, unless it is smaller than the range of a double, or an acceleration alone
 *     makes the distance fall; infinite if it is larger
 * @param impulse the impulse along the normal that the circle received, see {@link
 *     ImpactLog#impulse}; of a circle of no world as of mass 1, and 0 in the answer of a cast
 * @param outcome the outcome; in the answer of a cast {@link Outcome#BOUNCED}, or {@link
 *     Outcome#HALTED} if the thing that is hit {@linkplain Response#HALT halts} circles
 */
public record Impact(
    double time,
    int circle,
    Kind kind,
    int id,
    int part,
    Feature feature,
    double x,
    double y,
    double nx,
    double ny,
    double approachSpeed,
    double impulse,
    Outcome outcome) {

  /** The id in an answer of the detector alone, which knows no ids, and of a circle of no world. */
  static final int NO_ID = -1;

  /**
   * Checks that no component is null.
   *
   * @param time the time of impact
   * @param circle the id of the circle, or -1
   * @param kind the kind of thing that was hit
   * @param id the id of the thing
   * @param part the side of an outline, else 0
   * @param feature what of it was hit
   * @param x the x coordinate of the contact
   * @param y the y coordinate of the contact
   * @param nx the x component of the normal
   * @param ny the y component of the normal
   * @param approachSpeed the speed of approach
   * @param impulse the impulse that the circle received
   * @param outcome what the impact did
   */
  public Impact {
    Check.notNull("kind", kind);
    Check.notNull("feature", feature);
    Check.notNull("outcome", outcome);
  }

  /** The answer of a cast: an impact of no circle of a world, at a time from now. */
  static Impact of(double t, Kind kind, int id, int contact, Hit hit, boolean halts) {
    return new Impact(
        t,
        NO_ID,
        kind,
        id,
        0,
        kind == Kind.WALL ? Feature.SIDE : Feature.of(Contact.part(contact)),
        hit.x(),
        hit.y(),
        hit.nx(),
        hit.ny(),
        hit.approachSpeed(),
        0,
        halts ? Outcome.HALTED : Outcome.BOUNCED);
  }

  /** The first impact of a cast with an obstacle of a table. */
  static Impact of(MovingCircle m, int id, ObstacleTable obstacles, Hit hit) {
    int code = m.next;
    int feature = ObstacleTable.part(code, m.contact);
    int named = obstacles.named(code, feature);
    return new Impact(
        m.cleared,
        NO_ID,
        Kind.of(Codes.kind(code)),
        id,
        obstacles.side(named),
        Feature.of(obstacles.featureNamed(code, feature)),
        hit.x(),
        hit.y(),
        hit.nx(),
        hit.ny(),
        hit.approachSpeed(),
        0,
        obstacles.halts(code) ? Outcome.HALTED : Outcome.BOUNCED);
  }

  /**
   * Returns the contact point.
   *
   * @return the point (x, y)
   */
  public Vec2 point() {
    return new Vec2(x, y);
  }

  /**
   * Returns the unit normal, from the thing that was hit to the circle.
   *
   * @return the vector (nx, ny)
   */
  public Vec2 normal() {
    return new Vec2(nx, ny);
  }

  /**
   * Tells whether a thing took part, as the circle or as the thing that was hit.
   *
   * @param kind the kind of the thing
   * @param id its id
   * @return whether it is on one of the two sides
   */
  public boolean involves(Kind kind, int id) {
    Check.notNull("kind", kind);
    return (kind == Kind.CIRCLE && id == circle) || (kind == this.kind && id == this.id);
  }
}
