// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

/**
 * The true course of a scene whose circles ignore each other: the state of each circle at the end
 * of each frame, to the last place of a double.
 */
public interface Reference {

  /** The number of frames, from 0 (the start) to this one. */
  int frames();

  /** The number of circles. */
  int circles();

  /** The x coordinate of a circle's centre at the end of a frame, 0 for the start. */
  double x(int frame, int circle);

  /** The y coordinate of a circle's centre at the end of a frame, 0 for the start. */
  double y(int frame, int circle);

  /** The x component of a circle's velocity at the end of a frame. */
  double vx(int frame, int circle);

  /** The y component of a circle's velocity at the end of a frame. */
  double vy(int frame, int circle);

  /**
   * How much the scene multiplies relative errors of the start: the sum of |d position / d ln q|
   * over the start values q of the circle, as a base-10 logarithm, {@code Infinity} beyond 300.
   */
  double log10Conditioning(int frame, int circle);
}
