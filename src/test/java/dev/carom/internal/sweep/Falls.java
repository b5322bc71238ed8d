// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.Polynomial;
import dev.carom.internal.exact.UnitVector;

/** Questions about falling disks, with all numbers in one call. */
public final class Falls {
  private Falls() {}

  public static Fall line(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double gx,
      double gy,
      double ax,
      double ay,
      double bx,
      double by,
      double ux,
      double uy) {
    return Fall.ofThread().flight(px, py, r, vx, vy, gx, gy).line(ax, ay, bx, by, ux, uy);
  }

  public static Fall disk(
      double x1,
      double y1,
      double r1,
      double vx1,
      double vy1,
      double gx,
      double gy,
      double x2,
      double y2,
      double r2,
      double vx2,
      double vy2) {
    return Fall.ofThread().flight(x1, y1, r1, vx1, vy1, gx, gy).disk(x2, y2, r2, vx2, vy2);
  }

  public static double timeOfLine(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double gx,
      double gy,
      double ax,
      double ay,
      double bx,
      double by,
      double ux,
      double uy,
      double T) {
    return FallSweep.time(line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy), T);
  }

  public static double timeOfLineAfter(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double gx,
      double gy,
      double ax,
      double ay,
      double bx,
      double by,
      double ux,
      double uy,
      double s,
      double T) {
    return FallSweep.timeAfter(line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy), s, T);
  }

  public static int contact(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double gx,
      double gy,
      double ax,
      double ay,
      double bx,
      double by,
      double ux,
      double uy,
      double t) {
    return FallSweep.contact(line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy), t);
  }

  public static double timeOfDisk(
      double x1,
      double y1,
      double r1,
      double vx1,
      double vy1,
      double gx,
      double gy,
      double x2,
      double y2,
      double r2,
      double vx2,
      double vy2,
      double T) {
    return FallSweep.time(disk(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2), T);
  }

  public static double timeOfDiskAfter(
      double x1,
      double y1,
      double r1,
      double vx1,
      double vy1,
      double gx,
      double gy,
      double x2,
      double y2,
      double r2,
      double vx2,
      double vy2,
      double s,
      double T) {
    return FallSweep.timeAfter(disk(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2), s, T);
  }

  public static UnitVector normal(
      double x1,
      double y1,
      double r1,
      double vx1,
      double vy1,
      double gx,
      double gy,
      double x2,
      double y2,
      double r2,
      double vx2,
      double vy2,
      double t) {
    return FallSweep.normal(disk(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2), t);
  }

  public static double returnToDisk(
      double x1,
      double y1,
      double vx1,
      double vy1,
      double gx,
      double gy,
      double x2,
      double y2,
      double vx2,
      double vy2,
      double T) {
    return FallReturn.time(disk(x1, y1, 0, vx1, vy1, gx, gy, x2, y2, 0, vx2, vy2), T);
  }

  public static double returnToLine(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double gx,
      double gy,
      double ax,
      double ay,
      double bx,
      double by,
      double ux,
      double uy,
      double T) {
    return FallReturn.time(line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy), T);
  }

  public static int contactOfReturn(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double gx,
      double gy,
      double ax,
      double ay,
      double bx,
      double by,
      double ux,
      double uy,
      double t) {
    return FallReturn.contact(line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy), t);
  }

  /** The return to the height above a line, by algebraic numbers. */
  public static double exactReturnToSide(
      int side,
      double vx,
      double vy,
      double gx,
      double gy,
      double ax,
      double ay,
      double bx,
      double by,
      double ux,
      double uy,
      double T) {
    Fall fall = line(0, 0, 0, vx, vy, gx, gy, ax, ay, bx, by, ux, uy);
    Polynomial height = fall.gaps(Polynomial.EXACT).height();
    return ExactParabola.ofGap(height.signed(side).fromStart()).time(T);
  }

  public static double returnToSide(
      int side,
      double vx,
      double vy,
      double gx,
      double gy,
      double ax,
      double ay,
      double bx,
      double by,
      double ux,
      double uy,
      double T) {
    return FallReturn.toSide(line(0, 0, 0, vx, vy, gx, gy, ax, ay, bx, by, ux, uy), side, T);
  }

  public static Hit hitOfLine(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double gx,
      double gy,
      double ax,
      double ay,
      double bx,
      double by,
      double ux,
      double uy,
      int contact,
      double t) {
    Fall fall = line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy);
    return new Hit().of(fall, contact, t);
  }
}
