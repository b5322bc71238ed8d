// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.nio.ByteBuffer;

/**
 * The doubles in a class file's pool of constants (The Java Virtual Machine Specification, 4.4).
 * The compiler keeps one entry for each value, whatever the names and places it is used under, so
 * to replace an entry is to replace that value in the whole class.
 */
final class ConstantPool {
  private static final int HEADER = 8;
  private static final int UTF8 = 1;
  private static final int DOUBLE = 6;

  private final ByteBuffer bytes;

  ConstantPool(byte[] classFile) {
    bytes = ByteBuffer.wrap(classFile.clone());
  }

  /** The class file as it stands. */
  byte[] classFile() {
    return bytes.array().clone();
  }

  /** Puts another value in the place of one that must be there. */
  void replace(double value, double replacement) {
    int at = find(value);
    if (at < 0) {
      throw new IllegalArgumentException("no constant " + Double.toHexString(value));
    }
    bytes.putDouble(at, replacement);
  }

  /** Where the eight bytes of a value are; -1 if it is not there. */
  private int find(double value) {
    int count = Short.toUnsignedInt(bytes.getShort(HEADER));
    int at = HEADER + 2;
    for (int i = 1; i < count; i++) {
      int tag = bytes.get(at);
      if (tag == DOUBLE && Double.compare(bytes.getDouble(at + 1), value) == 0) {
        return at + 1;
      }
      at += 1 + size(tag, at + 1);
      // A long or a double counts as two entries.
      i += tag == 5 || tag == DOUBLE ? 1 : 0;
    }
    return -1;
  }

  /** The bytes of an entry behind its tag. */
  private int size(int tag, int at) {
    return switch (tag) {
      case UTF8 -> 2 + Short.toUnsignedInt(bytes.getShort(at));
      case 7, 8, 16, 19, 20 -> 2;
      case 15 -> 3;
      case 3, 4, 9, 10, 11, 12, 17, 18 -> 4;
      case 5, DOUBLE -> 8;
      default -> throw new IllegalArgumentException("no such tag: " + tag);
    };
  }
}
