// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.MovingCircle;
import java.util.Arrays;

/** The circles in contact, each by its slot: properties, flight, momentum, and what rest needs. */
final class Members {

  // Modes.

  /** Flies by exact events, and is no member. */
  static final byte OUT = MovingCircle.ALONE;

  /** Takes part in each tick. */
  static final byte AWAKE = MovingCircle.AWAKE;

  /** Rests in a frame, and is ground to the others. */
  static final byte FROZEN = MovingCircle.FROZEN;

  final int count;
  final byte[] mode;
  final double[] radius;
  final double[] inverseMass;
  final double[] restitution;
  final long[] filter;

  /** The flight: its start, its time, its velocity. */
  final double[] x;

  final double[] y;
  final double[] since;
  final double[] ux;
  final double[] uy;

  /** The momentum by mass, at one time for all, and its rate of change in the last tick. */
  final double[] vx;

  final double[] vy;
  final double[] ax;
  final double[] ay;

  /** How strongly it is pulled, see {@link ContactClock}. */
  final double[] pull;

  /** In units of gravity: the rate at which the momentum is shown within a tick. */
  final double[] rise;

  /** Whether it joined, or was joined, since the last tick. */
  final boolean[] fresh;

  /**
   * Whether its flight changed since the last tick, and its momentum follows that: only as it is
   * shown, or in truth.
   */
  final byte[] turned;

  static final byte SHOWN = 1;
  static final byte TRULY = 2;

  /** Where and since when it is calm, the velocity of its frame, and its load when it froze. */
  final double[] calmX;

  final double[] calmY;
  final double[] calmSince;
  final double[] frameX;
  final double[] frameY;
  final double[] load;

  /** Whether something passes over it: it stays where it is until nothing overlaps it. */
  final boolean[] jammed;

  Members(int count) {
    this.count = count;
    mode = new byte[count];
    radius = new double[count];
    inverseMass = new double[count];
    restitution = new double[count];
    filter = new long[count];
    x = new double[count];
    y = new double[count];
    since = new double[count];
    ux = new double[count];
    uy = new double[count];
    vx = new double[count];
    vy = new double[count];
    ax = new double[count];
    ay = new double[count];
    pull = new double[count];
    rise = new double[count];
    fresh = new boolean[count];
    turned = new byte[count];
    calmX = new double[count];
    calmY = new double[count];
    calmSince = new double[count];
    frameX = new double[count];
    frameY = new double[count];
    load = new double[count];
    jammed = new boolean[count];
    Arrays.fill(filter, FilterBits.DEFAULT);
  }

  boolean isAwake(int i) {
    return mode[i] == AWAKE;
  }

  boolean isFrozen(int i) {
    return mode[i] == FROZEN;
  }

  /** Whether a frozen circle can wake: nothing passes over it. */
  boolean canWake(int i) {
    return mode[i] == FROZEN && !jammed[i];
  }

  double xAt(int i, double time) {
    return x[i] + ux[i] * (time - since[i]);
  }

  double yAt(int i, double time) {
    return y[i] + uy[i] * (time - since[i]);
  }

  /** Starts a new flight at a time, of the same velocity, of which the host must be told. */
  void moveTo(int i, double time) {
    if (time != since[i]) {
      x[i] = xAt(i, time);
      y[i] = yAt(i, time);
      since[i] = time;
    }
  }

  void fly(int i, double velocityX, double velocityY) {
    ux[i] = velocityX;
    uy[i] = velocityY;
  }

  /**
   * Finds the rate along gravity at which the momentum is shown: its energy follows the work of
   * gravity on the flight, and no more than gravity changes it.
   */
  void follow(int i, double gx, double gy, double kick) {
    double g = Math.sqrt(gx * gx + gy * gy);
    if (g == 0) {
      rise[i] = 1;
      return;
    }
    double speed = (vx[i] * gx + vy[i] * gy) / g;
    double ofFlight = (ux[i] * gx + uy[i] * gy) / g;
    double rate = ofFlight * speed / Math.max(speed * speed, kick * kick);
    rise[i] = Math.max(-1, Math.min(1, rate));
  }

  /** At a tick, turns a momentum that followed a flight into one that gravity changes. */
  void takeTurn(int i, double gx, double gy, double momentTime, double now) {
    if (turned[i] == TRULY) {
      double more = (rise[i] - 1) * (now - momentTime);
      vx[i] += more * gx;
      vy[i] += more * gy;
    } else if (turned[i] == SHOWN) {
      vx[i] += (ax[i] - rise[i] * gx) * (momentTime - since[i]);
      vy[i] += (ay[i] - rise[i] * gy) * (momentTime - since[i]);
    }
    turned[i] = 0;
  }

  /** Gives a circle the momentum of its frame, which does not change. */
  void rest(int i) {
    vx[i] = frameX[i];
    vy[i] = frameY[i];
    turned[i] = 0;
    rise[i] = 0;
    ax[i] = 0;
    ay[i] = 0;
  }

  /** The pull on a pair: the stronger one of the two. */
  double pull(NearPairs p, int k) {
    int j = p.other[k];
    return j < count ? Math.max(pull[p.owner[k]], pull[j]) : pull[p.owner[k]];
  }

  double speed(int i) {
    return Math.sqrt(ux[i] * ux[i] + uy[i] * uy[i]);
  }

  /** The gap between two circles at a time; negative if they overlap. */
  double gap(int i, int j, double time) {
    double dx = xAt(i, time) - xAt(j, time);
    double dy = yAt(i, time) - yAt(j, time);
    return Math.sqrt(dx * dx + dy * dy) - radius[i] - radius[j];
  }
}
