// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;
import java.util.BitSet;

/**
 * The circles of a world by their ids, and what does not move of them: mass and {@link Traits}. An
 * id is not used again when its circle is removed.
 */
final class Roster {

  private double[] masses;

  /** Whether the scene uses the same array of masses. */
  private boolean shared;

  /** Null if no circle has any. */
  private byte[] traits;

  /** Which were removed; null as long as none was. */
  private boolean[] gone;

  private int end;
  private PresentCodes present;

  Roster(Scene scene) {
    end = scene.circleCount();
    present = new PresentCodes(0, end);
    masses = scene.masses;
    shared = true;
    traits = scene.circleTraits == null ? null : scene.circleTraits.clone();
  }

  private Roster(Roster other) {
    set(other);
  }

  /** Circles 0 .. masses.length - 1, some of which are gone. */
  Roster(double[] masses, byte[] traits, BitSet gone) {
    this.masses = masses;
    this.traits = traits;
    end = masses.length;
    present = new PresentCodes(0, end);
    gone.stream().forEach(this::remove);
  }

  Roster copy() {
    return new Roster(this);
  }

  /** Takes over what another one holds. */
  void set(Roster other) {
    masses = Arrays.copyOf(other.masses, other.end);
    shared = false;
    traits = other.traits == null ? null : Arrays.copyOf(other.traits, other.end);
    gone = other.gone == null ? null : Arrays.copyOf(other.gone, other.end);
    end = other.end;
    present = other.present.copy();
  }

  /** The number of circles. */
  int count() {
    return present.count();
  }

  /** Their ids, those of some that are gone too, until the next change. */
  PresentCodes present() {
    return present;
  }

  /** The ids of the circles that are there by now, ascending. */
  int[] ids() {
    int[] ids = new int[count()];
    int k = 0;
    for (int i = 0; i < present.size(); i++) {
      if (contains(present.get(i))) {
        ids[k++] = present.get(i);
      }
    }
    return ids;
  }

  /** How many impacts a circle may make in one place before it is stuck; see {@link World}. */
  int patience() {
    return 1_000 + 10 * count();
  }

  /** One more than the largest id. */
  int end() {
    return end;
  }

  boolean contains(int id) {
    return id >= 0 && id < end && (gone == null || !gone[id]);
  }

  /** Adds a circle of mass 1 and no special trait, and returns its id. */
  int add() {
    if (end == masses.length) {
      int capacity = 2 * end + 4;
      masses = Arrays.copyOf(masses, capacity);
      shared = false;
      traits = traits == null ? null : Arrays.copyOf(traits, capacity);
      gone = gone == null ? null : Arrays.copyOf(gone, capacity);
    }
    masses[end] = 1;
    present.add(end);
    return end++;
  }

  void remove(int id) {
    if (gone == null) {
      gone = new boolean[masses.length];
    }
    gone[id] = true;
    present.removed(1, i -> gone[i]);
  }

  double mass(int id) {
    return masses[id];
  }

  void setMass(int id, double m) {
    if (shared) {
      masses = masses.clone();
      shared = false;
    }
    masses[id] = m;
  }

  int traits(int id) {
    return traits == null ? 0 : traits[id];
  }

  void setTraits(int id, int t) {
    if (traits == null) {
      traits = new byte[masses.length];
    }
    traits[id] = (byte) t;
  }

  /** Whether any circle may have a trait. */
  boolean hasTraits() {
    return traits != null;
  }

  boolean isSensor(int id) {
    return traits != null && Traits.isSensor(traits[id]);
  }

  boolean halts(int id) {
    return traits != null && Traits.halts(traits[id]);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Roster that
        && end == that.end
        && Arrays.equals(ids(), that.ids())
        && Arrays.stream(ids()).allMatch(id -> isAlike(that, id));
  }

  private boolean isAlike(Roster that, int id) {
    return masses[id] == that.masses[id] && traits(id) == that.traits(id);
  }

  @Override
  public int hashCode() {
    return count();
  }
}
