// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.util.KindNumber;
import java.util.Arrays;

/**
 * The circles of a world, without their motion: their masses, {@link ContactFlags} and {@link
 * FilterBits}s. Callers name a circle by its id, which is never reused. The engine names it by its
 * slot, an array index. The arrays are compacted when most slots belong to removed circles. The
 * order of slots is the order of ids, so whatever the order of slots decides does not depend on
 * compaction.
 */
public final class CircleRegistry {

  /** The limit of ids: the code of the largest id is the largest int. */
  public static final int ID_LIMIT = Codes.limit(KindNumber.CIRCLE);

  private static final int NONE = -1;

  /**
   * Slots of removed circles that are tolerated besides the share of {@link #slack}: few cost
   * nothing.
   */
  private static final int SPARE_SLOTS = 1024;

  /** See {@link EngineOptions}. */
  private final double slack;

  /** The mass of the circle in each slot; NaN once it is removed. */
  private double[] masses;

  /** Whether a circle may have another mass than 1. */
  private boolean weighted;

  /** How many circles have infinite mass. */
  private int infinite;

  /** Whether the scene uses the same array of masses, which then must not be changed. */
  private boolean shared;

  /** By slots. */
  private TraitColumns traits;

  /** One more than the last slot. */
  private int end;

  private LiveCodes present;

  /** The id of each slot, ascending; null while each id equals its slot. */
  private int[] ids;

  private int idLimit;

  /** The slot found last. The next id asked for is often the one after it. */
  private int found;

  /** Creates a registry of no circles. */
  CircleRegistry() {
    this(new int[0], 0);
  }

  public CircleRegistry(SceneData scene, double slack) {
    this.slack = slack;
    masses = scene.registry.masses;
    shared = true;
    traits = scene.registry.traits.copy();
    assign(scene.registry.ids(), scene.registry.idLimit);
  }

  private CircleRegistry(CircleRegistry other) {
    slack = other.slack;
    set(other);
  }

  /**
   * Creates a registry of circles of mass 1 without traits, with the given ids, which are ascending
   * and below the limit.
   */
  public CircleRegistry(int[] ids, int idLimit) {
    slack = EngineOptions.CHOSEN.slack();
    masses = new double[ids.length];
    Arrays.fill(masses, 1);
    traits = new TraitColumns();
    assign(ids, idLimit);
  }

  public CircleRegistry copy() {
    return new CircleRegistry(this);
  }

  /** Copies the circles of another registry, or of this one, into adjacent slots. */
  public void set(CircleRegistry other) {
    int[] slots = other.slots();
    int[] theirIds = other.ids();
    double[] theirMasses = other.masses;
    masses = new double[slots.length];
    Arrays.setAll(masses, k -> theirMasses[slots[k]]);
    traits = other.traits.of(slots);
    shared = false;
    assign(theirIds, other.idLimit);
  }

  private void assign(int[] theirIds, int theirEnd) {
    end = theirIds.length;
    idLimit = theirEnd;
    ids = end == idLimit ? null : theirIds; // null if no id is missing
    present = new LiveCodes(0, end);
    found = 0;
    countInfinite();
  }

  private void countInfinite() {
    infinite = 0;
    weighted = false;
    for (int slot = 0; slot < end; slot++) {
      infinite += infinite(slot);
      weighted |= masses[slot] != 1;
    }
  }

  /** 1 for a circle of infinite mass, else 0. */
  private int infinite(int slot) {
    return masses[slot] == Double.POSITIVE_INFINITY ? 1 : 0;
  }

  /** Whether so many slots belong to removed circles that the arrays should be compacted. */
  public boolean isSparse() {
    return end - count() > slack * (count() + SPARE_SLOTS);
  }

  /** The number of circles. */
  public int count() {
    return present.count();
  }

  /**
   * The slots of the circles. Slots of some removed circles may linger. Valid until the next
   * change.
   */
  public LiveCodes present() {
    return present;
  }

  /** The slots of the live circles, ascending. */
  public int[] slots() {
    return present.stream(slot -> !contains(slot)).toArray();
  }

  public boolean contains(int slot) {
    return !Double.isNaN(masses[slot]);
  }

  // Ids.

  /** The ids of the live circles, ascending. */
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

  /** The slot of the circle with an id, which may be any int; negative if there is none. */
  public int slot(int id) {
    if (id < 0 || id >= idLimit) {
      return NONE;
    }
    int slot = ids == null ? id : find(id);
    return slot >= 0 && contains(slot) ? slot : NONE;
  }

  private int find(int id) {
    int slot = found; // a single read: several threads may query one snapshot
    if (slot + 1 < end && ids[slot + 1] == id) {
      slot++;
    } else if (slot >= end || ids[slot] != id) {
      slot = Arrays.binarySearch(ids, 0, end, id);
    }
    found = Math.max(slot, 0);
    return slot;
  }

  /**
   * Converts the slots of other circles in a circle's state to ids, for a snapshot. Drops a removed
   * one; for a sensed one stands the live circle before it.
   */
  public void toIds(MovingCircle m) {
    if (Codes.isCircle(m.last)) {
      int slot = Codes.slot(m.last);
      m.last = contains(slot) ? Codes.circle(id(slot)) : MovingCircle.NOTHING;
    }
    m.jam = ids == null || m.jam == null ? m.jam : m.jam.ofOtherCircles(this::id);
    if (m.sensedPartner >= 0) {
      m.sensedPartner = lastId(m.sensedPartner);
    }
  }

  /** The inverse of {@link #toIds}. */
  public void toSlots(MovingCircle m) {
    if (Codes.isCircle(m.last)) {
      m.last = Codes.circle(slot(Codes.slot(m.last)));
    }
    if (m.jam != null && ids != null) {
      m.jam = m.jam.ofOtherCircles(this::slot);
    }
    if (m.sensedPartner >= 0) {
      m.sensedPartner = slot(m.sensedPartner);
    }
  }

  /** The largest id of a live circle that is not above a given one; negative if none is. */
  int lastIdUpTo(int id) {
    int k = ids == null ? Math.min(id, end - 1) : Arrays.binarySearch(ids, 0, end, id);
    return lastId(k < 0 ? -2 - k : k);
  }

  /** The id of the last live circle up to a slot; negative if there is none. */
  int lastId(int slot) {
    int last = slot;
    while (last >= 0 && !contains(last)) {
      last--;
    }
    return last < 0 ? NONE : id(last);
  }

  // Changes.

  /** Adds a circle of mass 1 and no special trait, with the next id, and returns its slot. */
  public int add() {
    if (end == masses.length) {
      int capacity = 2 * end + 4;
      masses = Arrays.copyOf(masses, capacity);
      shared = false;
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
    setMass(slot, Double.NaN);
    present.removed(1, i -> !contains(i));
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
    weighted |= m != 1;
  }

  /** Whether any circle may have another mass than 1. Else masses need not be loaded. */
  public boolean areWeighted() {
    return weighted;
  }

  /** Whether any circle has infinite mass. */
  public boolean hasInfinite() {
    return infinite > 0;
  }

  /** Whether two or more circles have infinite mass. */
  public boolean haveInfinite() {
    return infinite > 1;
  }

  public int traits(int slot) {
    return traits.flags(slot);
  }

  public void setTraits(int slot, int t) {
    traits.setFlags(slot, t);
  }

  /** Whether any circle may have a trait. */
  public boolean hasTraits() {
    return traits.areFlagged();
  }

  public boolean isSensor(int slot) {
    return traits.areFlagged() && ContactFlags.isSensor(traits.flags(slot));
  }

  public boolean halts(int slot) {
    return traits.areFlagged() && ContactFlags.halts(traits.flags(slot));
  }

  public long filter(int slot) {
    return traits.filter(slot);
  }

  /** The filters of a registry whose slots are dense; null if each is the default. */
  public long[] filters() {
    return traits.filters(end);
  }

  public void setFilter(int slot, long filter) {
    traits.setFilter(slot, filter);
  }

  /** Whether two circles can meet. */
  public boolean meet(int i, int j) {
    return !traits.areFiltered() || FilterBits.meet(traits.filter(i), traits.filter(j));
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof CircleRegistry that
        && idLimit == that.idLimit
        && Arrays.equals(ids(), that.ids())
        && Arrays.stream(ids()).allMatch(id -> isAlike(slot(id), that, that.slot(id)));
  }

  private boolean isAlike(int slot, CircleRegistry that, int its) {
    return masses[slot] == that.masses[its]
        && traits(slot) == that.traits(its)
        && filter(slot) == that.filter(its);
  }

  @Override
  public int hashCode() {
    return count();
  }
}
