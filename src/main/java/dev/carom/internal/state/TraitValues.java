// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.util.Check;
import dev.carom.internal.util.KindNumber;

/**
 * All that a thing is, apart from its shape and its motion.
 *
 * @param mass 1 of all but circles
 * @param flags its {@link ContactFlags}
 * @param filter its {@link FilterBits}
 */
public record TraitValues(double restitution, double mass, int flags, long filter) {

  /** Refuses what a thing of a {@link KindNumber} cannot be. */
  public void check(int kind) {
    if (mass != 1 && kind != KindNumber.CIRCLE) {
      throw Check.refused("mass", mass, "1: only circles have another");
    }
    if (ContactFlags.isOneWay(flags) && kind != KindNumber.LINE) {
      throw Check.refused("oneWay", true, "false: only lines are one-way");
    }
    checkResponse(kind, ContactFlags.response(flags));
  }

  static void checkResponse(int kind, int response) {
    if (kind == KindNumber.WALL && response == ContactFlags.SENSOR) {
      throw Check.refused("response", "sensor", "bounce or halt: bounds keep circles inside");
    }
  }

  /** Gives an obstacle these traits. */
  public void set(ObstacleTable obstacles, int code) {
    obstacles.setRestitution(code, restitution);
    obstacles.setTraits(code, flags);
    obstacles.setFilter(code, filter);
  }

  /** Gives a circle these traits; its restitution stands elsewhere. */
  public void set(CircleRegistry circles, int slot) {
    circles.setMass(slot, mass);
    circles.setTraits(slot, flags);
    circles.setFilter(slot, filter);
  }
}
