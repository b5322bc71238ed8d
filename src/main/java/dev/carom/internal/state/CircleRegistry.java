// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.util.Kind;
import java.util.Arrays;

/**
 * The circles of a world, and what does not move of them: mass and {@link ContactFlags}. Callers
 * name a circle by its id, which is not used again; the engine, by its slot in arrays, which are
 * made dense anew when most slots are of circles that were removed. Who has the larger id has the
 * larger slot, so that what the order of slots decides does not depend on that.
 */
public final class CircleRegistry {

  /** One more than the largest id: its code is the largest number. */
  public static final int ID_LIMIT = Codes.limit(Kind.CIRCLE);

  private static final int NONE = -1;

  /** So many more circles are counted where slots of removed ones are: a few are no burden. */
  private static final int SPARE_SLOTS = 1024;

  /** See {@link EngineOptions}. */
  private final double slack;

  private double[] masses;

  /** How many circles have infinite mass. */
  private int infinite;

  /** Whether the scene uses the same array of masses. */
  private boolean shared;

  /** Null if no circle has any. */
  private byte[] traits;

  /** Which were removed; null as long as none was. */
  private boolean[] gone;

  /** One more than the last slot. */
  private int end;

  private LiveCodes present;

  /** The id of each slot, ascending; null while it is its number. */
  private int[] ids;

  private int idLimit;

  /** Where an id was found last: the next one asked for is often the next one. */
  private int found;

  public CircleRegistry(SceneData scene, double slack) {
    this.slack = slack;
    end = scene.circleCount();
    idLimit = end;
    present = new LiveCodes(0, end);
    masses = scene.masses;
    shared = true;
    countInfinite();
    traits = scene.circleTraits == null ? null : scene.circleTraits.clone();
  }

  private CircleRegistry(CircleRegistry other) {
    slack = other.slack;
    set(other);
  }

  /** Circles with the given ids, ascending and below their end. */
  public CircleRegistry(double[] masses, byte[] traits, int[] ids, int idLimit) {
    slack = EngineOptions.CHOSEN.slack();
    this.masses = masses;
    this.traits = traits;
    assign(ids, idLimit);
  }

  public CircleRegistry copy() {
    return new CircleRegistry(this);
  }

  /** Takes over the circles that another one, or this one, holds, without room between them. */
  public void set(CircleRegistry other) {
    int[] slots = other.slots();
    int[] theirIds = other.ids();
    double[] theirMasses = other.masses;
    byte[] theirTraits = other.traits;
    masses = new double[slots.length];
    traits = theirTraits == null ? null : new byte[slots.length];
    for (int k = 0; k < slots.length; k++) {
      masses[k] = theirMasses[slots[k]];
      if (traits != null) {
        traits[k] = theirTraits[slots[k]];
      }
    }
    shared = false;
    assign(theirIds, other.idLimit);
  }

  private void assign(int[] theirIds, int theirEnd) {
    end = theirIds.length;
    idLimit = theirEnd;
    ids = end == idLimit ? null : theirIds; // else they are all there
    gone = null;
    present = new LiveCodes(0, end);
    found = 0;
    countInfinite();
  }

  private void countInfinite() {
    infinite = 0;
    for (int slot = 0; slot < end; slot++) {
      infinite += infinite(slot);
    }
  }

  /** 1 for a circle of infinite mass, else 0. */
  private int infinite(int slot) {
    return masses[slot] == Double.POSITIVE_INFINITY ? 1 : 0;
  }

  /** Whether so many slots are of circles that were removed that arrays are to be made dense. */
  public boolean isSparse() {
    return end - count() > slack * (count() + SPARE_SLOTS);
  }

  /** The number of circles. */
  public int count() {
    return present.count();
  }

  /** Their slots, those of some that are gone too, until the next change. */
  public LiveCodes present() {
    return present;
  }

  /** The slots of the circles that are there by now, ascending. */
  public int[] slots() {
    return present.stream(slot -> !contains(slot)).toArray();
  }

  public boolean contains(int slot) {
    return gone == null || !gone[slot];
  }

  // Ids.

  /** The ids of the circles that are there by now, ascending. */
  public int[] ids() {
    int[] slots = slots();
    Arrays.setAll(slots, k -> id(slots[k]));
    return slots;
  }

  /** One more than the largest id ever given. */
  public int idLimit() {
    return idLimit;
  }

  /** The id of the circle that is, or was, at a slot. */
  public int id(int slot) {
    return ids == null ? slot : ids[slot];
  }

  /** The slot of the circle with an id, for any number; below 0 if there is none. */
  public int slot(int id) {
    if (id < 0 || id >= idLimit) {
      return NONE;
    }
    int slot = ids == null ? id : find(id);
    return slot >= 0 && contains(slot) ? slot : NONE;
  }

  private int find(int id) {
    int slot = found; // once: snapshots are asked by several threads
    if (slot + 1 < end && ids[slot + 1] == id) {
      slot++;
    } else if (slot >= end || ids[slot] != id) {
      slot = Arrays.binarySearch(ids, 0, end, id);
    }
    found = Math.max(slot, 0);
    return slot;
  }

  /** The id of the last circle that is there up to a slot, below 0 if there is none. */
  public int lastId(int slot) {
    int last = slot;
    while (last >= 0 && !contains(last)) {
      last--;
    }
    return last < 0 ? NONE : id(last);
  }

  /** What a mover knows of other circles, by their ids; nothing of one that was removed. */
  public void toIds(MovingCircle m) {
    if (Codes.isCircle(m.last)) {
      int slot = Codes.slot(m.last);
      m.last = contains(slot) ? Codes.circle(id(slot)) : MovingCircle.NOTHING;
    }
    if (m.jam != null && ids != null) {
      m.jam = m.jam.ofOtherCircles(this::id);
    }
  }

  /** The opposite of {@link #toIds}. */
  public void toSlots(MovingCircle m) {
    if (Codes.isCircle(m.last)) {
      m.last = Codes.circle(slot(Codes.slot(m.last)));
    }
    if (m.jam != null && ids != null) {
      m.jam = m.jam.ofOtherCircles(this::slot);
    }
  }

  // Changes.

  /** Adds a circle of mass 1 and no special trait, with the next id, and returns its slot. */
  public int add() {
    if (end == masses.length) {
      int capacity = 2 * end + 4;
      masses = Arrays.copyOf(masses, capacity);
      shared = false;
      traits = traits == null ? null : Arrays.copyOf(traits, capacity);
      gone = gone == null ? null : Arrays.copyOf(gone, capacity);
      ids = ids == null ? null : Arrays.copyOf(ids, capacity);
    }
    masses[end] = 1;
    present.add(end);
    if (ids != null) {
      ids[end] = idLimit;
    }
    idLimit++;
    return end++;
  }

  public void remove(int slot) {
    if (gone == null) {
      gone = new boolean[masses.length];
    }
    gone[slot] = true;
    infinite -= infinite(slot);
    present.removed(1, i -> gone[i]);
  }

  public double mass(int slot) {
    return masses[slot];
  }

  public void setMass(int slot, double m) {
    if (shared) {
      masses = masses.clone();
      shared = false;
    }
    infinite -= infinite(slot);
    masses[slot] = m;
    infinite += infinite(slot);
  }

  /** Whether two or more circles have infinite mass. */
  public boolean hasInfinite() {
    return infinite > 1;
  }

  public int traits(int slot) {
    return traits == null ? 0 : traits[slot];
  }

  public void setTraits(int slot, int t) {
    if (traits == null) {
      traits = new byte[masses.length];
    }
    traits[slot] = (byte) t;
  }

  /** Whether any circle may have a trait. */
  public boolean hasTraits() {
    return traits != null;
  }

  public boolean isSensor(int slot) {
    return traits != null && ContactFlags.isSensor(traits[slot]);
  }

  public boolean halts(int slot) {
    return traits != null && ContactFlags.halts(traits[slot]);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof CircleRegistry that
        && idLimit == that.idLimit
        && Arrays.equals(ids(), that.ids())
        && Arrays.stream(ids()).allMatch(id -> isAlike(slot(id), that, that.slot(id)));
  }

  private boolean isAlike(int slot, CircleRegistry that, int its) {
    return masses[slot] == that.masses[its] && traits(slot) == that.traits(its);
  }

  @Override
  public int hashCode() {
    return count();
  }
}
