// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * What edits may change of a circle, and nothing else does.
 *
 * @param traits its {@link ContactFlags}
 * @param filter its {@link FilterBits}
 * @param confined whether walls keep it inside
 */
record CircleProperties(
    double radius, double mass, double restitution, int traits, long filter, boolean confined) {

  /** The properties of a circle; a known object, if it has the same. */
  static CircleProperties of(
      MovingCircle m, CircleRegistry registry, ObstacleTable obstacles, CircleProperties known) {
    double mass = registry.mass(m.id);
    int traits = registry.traits(m.id);
    long filter = registry.filter(m.id);
    boolean confined = obstacles.wallsFor(filter) != null;
    boolean isSame =
        known != null
            && m.radius == known.radius
            && mass == known.mass
            && m.restitution == known.restitution
            && traits == known.traits
            && filter == known.filter
            && confined == known.confined;
    return isSame
        ? known
        : new CircleProperties(m.radius, mass, m.restitution, traits, filter, confined);
  }
}
