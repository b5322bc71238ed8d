// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

/** The course of a scene as it was stored. */
final class StoredReference implements Reference {

  private final int frames;

  /** x, y, vx, vy, by circle and frame. */
  private final double[][][] states;

  private final float[][] conditioning;

  StoredReference(int frames, double[][][] states, float[][] conditioning) {
    this.frames = frames;
    this.states = states;
    this.conditioning = conditioning;
  }

  @Override
  public int frames() {
    return frames;
  }

  @Override
  public int circles() {
    return states.length;
  }

  @Override
  public double x(int frame, int circle) {
    return states[circle][frame][0];
  }

  @Override
  public double y(int frame, int circle) {
    return states[circle][frame][1];
  }

  @Override
  public double vx(int frame, int circle) {
    return states[circle][frame][2];
  }

  @Override
  public double vy(int frame, int circle) {
    return states[circle][frame][3];
  }

  @Override
  public double log10Conditioning(int frame, int circle) {
    return conditioning[circle][frame];
  }
}
