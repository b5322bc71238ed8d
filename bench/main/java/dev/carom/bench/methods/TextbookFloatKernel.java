// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/** The test of the textbooks as {@link TextbookDetector} has it, every double a float. */
public final class TextbookFloatKernel {

  private static final float NEVER = Float.POSITIVE_INFINITY;

  int squareRoots;
  long pairTests;

  /**
   * {@link TextbookDetector#time} in float.
   *
   * @param px the x coordinate of the centre
   * @param py the y coordinate of the centre
   * @param r the radius
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @param ax the x coordinate of the line's start
   * @param ay the y coordinate of the line's start
   * @param bx the x coordinate of the line's end
   * @param by the y coordinate of the line's end
   * @param end the end of the window
   * @return the time of impact, infinite for a miss
   */
  public float time(
      float px,
      float py,
      float r,
      float vx,
      float vy,
      float ax,
      float ay,
      float bx,
      float by,
      float end) {
    pairTests++;
    float ex = px - ax;
    float ey = py - ay;
    float wx = bx - ax;
    float wy = by - ay;
    float cross = wx * ey - wy * ex;
    float drift = wx * vy - wy * vx;
    if (cross * drift < 0) {
      squareRoots++;
      float ww = wx * wx + wy * wy;
      float t = Math.max(0, (Math.abs(cross) - r * (float) Math.sqrt(ww)) / Math.abs(drift));
      float along = wx * (ex + t * vx) + wy * (ey + t * vy);
      if (along > 0 && along < ww) {
        return t <= end ? t : NEVER;
      }
    }
    return Math.min(point(ex, ey, r, vx, vy, end), point(px - bx, py - by, r, vx, vy, end));
  }

  /** a t^2 + 2 b t + c = 0 with a = v.v, b = e.v, c = e.e - r^2 */
  private float point(float ex, float ey, float r, float vx, float vy, float end) {
    float b = ex * vx + ey * vy;
    if (b >= 0) {
      return NEVER;
    }
    float c = ex * ex + ey * ey - r * r;
    if (c <= 0) {
      return 0;
    }
    float a = vx * vx + vy * vy;
    float discriminant = b * b - a * c;
    if (discriminant <= 0) {
      return NEVER;
    }
    squareRoots++;
    float t = (-b - (float) Math.sqrt(discriminant)) / a;
    return t <= end ? t : NEVER;
  }
}
