// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import java.util.Arrays;

/**
 * Pairs that are near each other, in flat arrays: of an awake circle, the owner, with another
 * circle or a part of an obstacle. A circle that an obstacle stands for is the last one, {@code
 * members.count}.
 */
final class NearPairs {

  int size;
  int[] owner = new int[16];
  int[] other = new int[16];

  /** The part of an obstacle, or NONE, and its key. */
  int[] part = new int[16];

  long[] key = new long[16];

  /** Where the pairs of the k-th owner begin. */
  int[] start;

  /** The impulse of the last solve. */
  double[] impulse = new double[16];

  /** Whether it bore on a frozen circle; whether the owner passes through the part. */
  boolean[] bore = new boolean[16];

  boolean[] through = new boolean[16];

  // What the last measurement found: the unit normal, to the owner; the gap; the speed along the
  // normal of what does not take part; whether the pair counts.
  double[] nx = new double[16];
  double[] ny = new double[16];
  double[] gap = new double[16];
  double[] drift = new double[16];
  boolean[] felt = new boolean[16];

  /** The standoff, the restitution, and the distance of the centres of what is round, or 0. */
  double[] standoff = new double[16];

  double[] bounce = new double[16];
  double[] round = new double[16];

  NearPairs(int circles) {
    start = new int[circles + 1];
  }

  void makeRoom(int room) {
    if (room <= owner.length) {
      return;
    }
    int more = Math.max(room, 2 * owner.length);
    owner = Arrays.copyOf(owner, more);
    other = Arrays.copyOf(other, more);
    part = Arrays.copyOf(part, more);
    key = Arrays.copyOf(key, more);
    impulse = Arrays.copyOf(impulse, more);
    bore = Arrays.copyOf(bore, more);
    through = Arrays.copyOf(through, more);
    nx = Arrays.copyOf(nx, more);
    ny = Arrays.copyOf(ny, more);
    gap = Arrays.copyOf(gap, more);
    drift = Arrays.copyOf(drift, more);
    felt = Arrays.copyOf(felt, more);
    standoff = Arrays.copyOf(standoff, more);
    bounce = Arrays.copyOf(bounce, more);
    round = Arrays.copyOf(round, more);
  }

  /** Copies what a pair keeps when the list is made anew. */
  void copy(int to, int from) {
    owner[to] = owner[from];
    other[to] = other[from];
    part[to] = part[from];
    key[to] = key[from];
    impulse[to] = impulse[from];
    bore[to] = bore[from];
    through[to] = through[from];
  }

  /** The velocity of the gap of a pair, for velocities by circles. */
  double opening(double[] q, int k) {
    int a = 2 * owner[k];
    int b = 2 * other[k];
    return (q[a] - q[b]) * nx[k] + (q[a + 1] - q[b + 1]) * ny[k] - drift[k];
  }

  /** The relative speed of two circles. */
  double speed(double[] q, int k) {
    double x = q[2 * owner[k]] - q[2 * other[k]];
    double y = q[2 * owner[k] + 1] - q[2 * other[k] + 1];
    return Math.sqrt(x * x + y * y);
  }

  /** Deep overlaps are there from the start, and nothing pushes them apart. */
  boolean isDeep(int k) {
    return gap[k] < -standoff[k] / 2;
  }

  /**
   * The least speed of the gap of a pair that is left a distance at the end of a tick: some of it,
   * where the gap is smaller.
   */
  double leaving(double distance, int k, double h) {
    double back = distance - gap[k];
    return isDeep(k) ? 0 : (back > 0 ? ContactLaw.BACK * back : back) / h;
  }

  /** Whether a pair would meet within a time, by more than rounding. */
  boolean meets(double[] u, int k, double time, double radius) {
    double least = Math.min(0, -gap[k] - ContactLaw.SLACK * radius);
    return felt[k] && opening(u, k) * time < least;
  }
}
