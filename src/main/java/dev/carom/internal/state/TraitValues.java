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

  /** Refuses what a thing of a {@link KindNumber}, of an outside as polygons have, cannot be. */
  public void check(int kind, int outside) {
    if (mass != 1 && kind != KindNumber.CIRCLE) {
      throw Check.refused("mass", mass, "1: only circles have another");
    }
    if (ContactFlags.isOneWay(flags) && kind != KindNumber.LINE) {
      throw Check.refused("oneWay", true, "false: only lines are one-way");
    }
    checkOneWay("oneWay", ContactFlags.isOneWay(flags), outside);
    checkResponse(kind, ContactFlags.response(flags));
  }

  /** Refuses that a solid outline is one-way; 0 is the outside of other things. */
  static void checkOneWay(String name, boolean isOneWay, int outside) {
    if (isOneWay && outside != 0) {
      throw Check.refused(name, true, "false: a solid outline keeps circles out on all sides");
    }
  }

  static void checkResponse(int kind, int response) {
    if (kind == KindNumber.WALL && response == ContactFlags.SENSOR) {
      throw Check.refused("response", "sensor", "bounce or halt: bounds keep circles inside");
    }
  }

  /** Whether the flags of an obstacle are these: what it is outside of is not a trait. */
  public boolean areFlagsOf(ObstacleTable obstacles, int code) {
    return ContactFlags.withOutside(flags, obstacles.outside(code)) == obstacles.traits(code);
  }

  /** Gives an obstacle these traits; an outline, all its sides. */
  public void set(ObstacleTable obstacles, int code) {
    int end = obstacles.endOf(code);
    for (int each = obstacles.firstOf(code); each < end; each++) {
      obstacles.setRestitution(each, restitution);
      obstacles.setTraits(each, ContactFlags.withOutside(flags, obstacles.outside(each)));
      obstacles.setFilter(each, filter);
    }
  }

  /** Gives a circle these traits; its restitution stands elsewhere. */
  public void set(CircleRegistry circles, int slot) {
    circles.setMass(slot, mass);
    circles.setTraits(slot, flags);
    circles.setFilter(slot, filter);
  }
}
