// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.Polynomial;
import dev.carom.internal.exact.UnitVector;
import dev.carom.oracle.Part;

/**
 * Questions about falling disks, with all numbers in one call: place, radius, velocity and
 * acceleration of the disk; the ends of a line, or place and radius of another disk; its velocity;
 * last the times.
 */
public final class Falls {
  private Falls() {}

  public static Fall line(double... q) {
    return Fall.ofThread()
        .flight(q[0], q[1], q[2], q[3], q[4], q[5], q[6])
        .line(q[7], q[8], q[9], q[10], q[11], q[12]);
  }

  public static Fall disk(double... q) {
    return Fall.ofThread()
        .flight(q[0], q[1], q[2], q[3], q[4], q[5], q[6])
        .disk(q[7], q[8], q[9], q[10], q[11]);
  }

  public static double timeOfLine(double... q) {
    return FallSweep.time(line(q), q[13]);
  }

  public static double timeOfLineAfter(double... q) {
    return FallSweep.timeAfter(line(q), q[13], q[14]);
  }

  public static int contact(double... q) {
    return FallSweep.contact(line(q), q[13]);
  }

  public static double timeOfDisk(double... q) {
    return FallSweep.time(disk(q), q[12]);
  }

  public static double timeOfDiskAfter(double... q) {
    return FallSweep.timeAfter(disk(q), q[12], q[13]);
  }

  public static UnitVector normal(double... q) {
    return FallSweep.normal(disk(q), q[12]);
  }

  /** Without radii: they do not matter. */
  public static double returnToDisk(double... q) {
    return FallReturn.time(touchedDisk(q), q[10]);
  }

  /** The same by algebraic numbers. */
  public static double exactReturnToDisk(double... q) {
    return FallReturn.exact(touchedDisk(q)).time(q[10]);
  }

  private static Fall touchedDisk(double... q) {
    return disk(q[0], q[1], 0, q[2], q[3], q[4], q[5], q[6], q[7], 0, q[8], q[9]);
  }

  public static double returnToLine(double... q) {
    return FallReturn.time(line(q), q[13]);
  }

  public static int contactOfReturn(double... q) {
    return FallReturn.contact(line(q), q[13]);
  }

  /** The side first, and no place and radius: they do not matter. */
  public static double returnToSide(double... q) {
    return FallReturn.toSide(ofSide(q), (int) q[0], q[11]);
  }

  /** The same by algebraic numbers. */
  public static double exactReturnToSide(double... q) {
    Polynomial height = ofSide(q).gaps(Polynomial.EXACT).height();
    return ExactParabola.ofGap(height.signed((int) q[0]).fromStart()).time(q[11]);
  }

  private static Fall ofSide(double[] q) {
    return line(0, 0, 0, q[1], q[2], q[3], q[4], q[5], q[6], q[7], q[8], q[9], q[10]);
  }

  /** The part of a line that a contact is with. */
  public static Part part(int contact) {
    return switch (Contact.withoutTime(contact)) {
      case Contact.START -> Part.START;
      case Contact.END -> Part.END;
      default -> Part.SIDE;
    };
  }
}
