// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.SavedFlights;
import dev.carom.internal.state.TimelineRecorder;
import java.util.Arrays;

/**
 * The last contact of two circles that a sensor reported, for each circle's flight. This contact
 * and all earlier ones are not reported again. Contacts are ordered by time (head, tail), then by
 * partner.
 */
public final class SensorPairs {

  // Null until a contact is reported; a head of -1 stands for none.
  private double[] heads;
  private double[] tails;
  private int[] partners;

  /** Records a reported contact of circle i with a partner. */
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

  /** Forgets the contacts of circle i, which begins a new flight. */
  public void forget(int i) {
    if (heads != null && i < heads.length) {
      heads[i] = -1;
    }
  }

  public void clear() {
    heads = null;
  }

  /** Whether a contact of circle i has yet to be reported. */
  public boolean isNew(int i, double head, double tail, int partner) {
    if (heads == null || i >= heads.length || head != heads[i]) {
      return heads == null || i >= heads.length || head > heads[i];
    }
    return tail != tails[i] ? tail > tails[i] : partner > partners[i];
  }

  /**
   * Saves the last reported contact of circle i as number k. A removed partner is saved as the live
   * circle before it.
   */
  public void save(int i, CircleRegistry registry, int k, SavedFlights states) {
    if (heads != null && i < heads.length) {
      states.putSensed(k, heads[i], tails[i], registry.lastId(partners[i]));
    } else {
      states.putSensed(k, -1, 0, 0);
    }
  }

  /** Records the last reported contact of circle i, if there is one. */
  public void record(int i, TimelineRecorder recorder) {
    if (heads != null && i < heads.length && heads[i] >= 0) {
      recorder.noteSensed(i, heads[i], tails[i], partners[i]);
    }
  }

  /** Restores the last reported contact of circle i, which is number i of the live ones. */
  public void restore(int i, CircleRegistry registry, SavedFlights states) {
    double head = states.sensedHead(i);
    if (head >= 0) {
      report(i, head, states.sensedTail(i), registry.slot(states.sensedPartner(i)));
    }
  }
}
