// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.Contact;

/**
 * One int for the contact of a circle's next impact and the history of its impacts at one place.
 * From the lowest bit on: the {@link Contact} (4 bits), whether the circle is pushed (1 bit), and
 * whether it settled (1 bit).
 */
public final class ContactWord {

  /** The number of its bits. */
  static final int BITS = 6;

  private static final int CONTACT = 15;
  private static final int PUSHED = 1 << 4;
  private static final int SETTLED = 1 << 5;

  private ContactWord() {}

  /** Encodes a circle's history of impacts with the contact of its next one. */
  static int of(MovingCircle m) {
    return (m.pushed ? PUSHED : 0) | (m.settled ? SETTLED : 0) | m.contact;
  }

  /** The inverse of {@link #of}. */
  static void recall(int word, MovingCircle m) {
    m.contact = word & CONTACT;
    m.pushed = (word & PUSHED) != 0;
    m.settled = (word & SETTLED) != 0;
  }
}
