// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.util.Check;
import dev.carom.internal.util.DoubleList;
import dev.carom.internal.util.IntList;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;

/**
 * The bytes of a snapshot, one field after the other. A stream that writes returns each field as it
 * was given. One that reads ignores what is given and returns what it read. So one list of fields
 * serves both.
 */
final class FieldStream {

  /** Where to read; null if this stream writes. */
  private final DataInputStream in;

  private final DataOutputStream out;

  FieldStream(DataInputStream in, DataOutputStream out) {
    this.in = in;
    this.out = out;
  }

  double number(double given) throws IOException {
    return Double.longBitsToDouble(bits(Double.doubleToLongBits(given)));
  }

  int integer(int given) throws IOException {
    if (in != null) {
      return in.readInt();
    }
    out.writeInt(given);
    return given;
  }

  long bits(long given) throws IOException {
    if (in != null) {
      return in.readLong();
    }
    out.writeLong(given);
    return given;
  }

  int octet(int given) throws IOException {
    if (in != null) {
      return in.readByte();
    }
    out.writeByte(given);
    return given;
  }

  boolean flag(boolean given) throws IOException {
    return octet(given ? 1 : 0) != 0;
  }

  /** A number of things, which is refused if it is read and above a limit. */
  int count(int given, int most) throws IOException {
    int count = integer(given);
    if (count < 0 || count > most) {
      throw Check.refused("count", count, "0 to " + most);
    }
    return count;
  }

  /**
   * So many rows of numbers. The array that is read grows with them: a count alone takes nothing.
   */
  double[] numbers(double[] given, int rows, int width) throws IOException {
    DoubleList read = new DoubleList();
    for (long k = 0; k < (long) rows * width; k++) {
      double number = number(in == null ? given[(int) k] : 0);
      if (in != null) {
        read.add(number);
      }
    }
    return in == null ? given : read.toArray();
  }

  /** So many rows of integers. */
  int[] integers(int[] given, int rows, int width) throws IOException {
    IntList read = new IntList();
    for (long k = 0; k < (long) rows * width; k++) {
      int integer = integer(in == null ? given[(int) k] : 0);
      if (in != null) {
        read.add(integer);
      }
    }
    return in == null ? given : read.toArray();
  }
}
