// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * What an edit may change of a circle within a flight.
 *
 * @param traits its {@link ContactFlags}
 * @param filter its {@link FilterBits}
 * @param confined whether walls keep it inside
 */
record CircleProperties(
    double mass, double restitution, int traits, long filter, boolean confined) {

  /** The properties of a circle; a known object, if it has the same. */
  static CircleProperties of(
      MovingCircle m, CircleRegistry registry, ObstacleTable obstacles, CircleProperties known) {
    double mass = registry.mass(m.id);
    int traits = registry.traits(m.id);
    long filter = registry.filter(m.id);
    boolean confined = obstacles.wallsFor(filter) != null;
    boolean isSame =
        known != null
            && mass == known.mass
            && m.restitution == known.restitution
            && traits == known.traits
            && filter == known.filter
            && confined == known.confined;
    return isSame ? known : new CircleProperties(mass, m.restitution, traits, filter, confined);
  }
}
