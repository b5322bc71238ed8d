// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.SavedFlights;
import java.util.Arrays;

/**
 * The last meeting of each circle's flight that a sensor reported: it and those before it are not
 * reported again. Meetings stand in the order of time (head, tail), then of the partner.
 */
public final class SensorPairs {

  // Null until there is one; a head of -1 stands for none.
  private double[] heads;
  private double[] tails;
  private int[] partners;

  /** Notes that circle i met a partner. */
  public void report(int i, double head, double tail, int partner) {
    if (heads == null) {
      heads = new double[0];
      tails = new double[0];
      partners = new int[0];
    }
    if (i >= heads.length) {
      int size = heads.length;
      heads = Arrays.copyOf(heads, 2 * i + 4);
      tails = Arrays.copyOf(tails, heads.length);
      partners = Arrays.copyOf(partners, heads.length);
      Arrays.fill(heads, size, heads.length, -1);
    }
    heads[i] = head;
    tails[i] = tail;
    partners[i] = partner;
  }

  /** Begins a new flight of circle i. */
  public void forget(int i) {
    if (heads != null && i < heads.length) {
      heads[i] = -1;
    }
  }

  public void clear() {
    heads = null;
  }

  /** Whether a meeting of circle i is still to be reported. */
  public boolean isNew(int i, double head, double tail, int partner) {
    if (heads == null || i >= heads.length || head != heads[i]) {
      return heads == null || i >= heads.length || head > heads[i];
    }
    return tail != tails[i] ? tail > tails[i] : partner > partners[i];
  }

  /** Takes down, as number k, what circle i sensed; a partner that is gone, as who is before it. */
  public void save(int i, CircleRegistry registry, int k, SavedFlights states) {
    if (heads != null && i < heads.length) {
      states.putSensed(k, heads[i], tails[i], registry.lastId(partners[i]));
    } else {
      states.putSensed(k, -1, 0, 0);
    }
  }

  /** Takes over what circle i, number i of those that are there, sensed. */
  public void restore(int i, CircleRegistry registry, SavedFlights states) {
    double head = states.sensedHead(i);
    if (head >= 0) {
      report(i, head, states.sensedTail(i), registry.slot(states.sensedPartner(i)));
    }
  }
}
