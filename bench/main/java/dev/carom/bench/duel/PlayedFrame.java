// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.duel;

import java.util.BitSet;

/** The circles of a scene at the end of a frame, by one method, and the failures up to it. */
public final class PlayedFrame {

  /** Doubles of one circle: x, y, vx, vy. */
  private static final int CIRCLE = 4;

  private final double[] states;
  private final BitSet lost;
  private final double penetration;
  private final double energy;
  private final double micros;

  PlayedFrame(double[] states, BitSet lost, double penetration, double energy, double micros) {
    this.states = states;
    this.lost = lost;
    this.penetration = penetration;
    this.energy = energy;
    this.micros = micros;
  }

  /** The number of circles: at least 0. */
  public int circles() {
    return states.length / CIRCLE;
  }

  /**
   * Where a circle is.
   *
   * @param i its number in the scene
   * @return the x coordinate of its centre, any number
   */
  public double x(int i) {
    return states[CIRCLE * i];
  }

  /**
   * Where a circle is.
   *
   * @param i its number in the scene
   * @return the y coordinate of its centre, any number
   */
  public double y(int i) {
    return states[CIRCLE * i + 1];
  }

  /**
   * How a circle moves.
   *
   * @param i its number in the scene
   * @return the x component of its velocity, any number
   */
  public double vx(int i) {
    return states[CIRCLE * i + 2];
  }

  /**
   * How a circle moves.
   *
   * @param i its number in the scene
   * @return the y component of its velocity, any number
   */
  public double vy(int i) {
    return states[CIRCLE * i + 3];
  }

  /**
   * Whether a circle got through a line, or out of the bounds, in this frame or before.
   *
   * @param i its number in the scene
   */
  public boolean isLost(int i) {
    return lost.get(i);
  }

  /** How many are lost: at least 0. */
  public int lost() {
    return lost.cardinality();
  }

  /** A copy of those that are lost. */
  BitSet lostCircles() {
    return (BitSet) lost.clone();
  }

  /**
   * How deep any circle ever reached into a line, a wall or another circle at the end of a frame:
   * in radii, at least 0; not counted once it is lost.
   */
  public double penetration() {
    return penetration;
  }

  /**
   * The energy: kinetic, and under gravity also potential, from the lowest place within the bounds
   * on.
   *
   * @return as a part of that at the start; NaN if there was none, or under gravity without bounds
   */
  public double energy() {
    return energy;
  }

  /** The time of a frame: the median of the last 60 frames, in microseconds; NaN at the start. */
  public double micros() {
    return micros;
  }
}
