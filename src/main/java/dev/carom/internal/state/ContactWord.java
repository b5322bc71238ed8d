// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.Contact;

/**
 * One int for the contact of a circle's next impact and the history of its impacts at one place.
 * From the lowest bit on: the {@link Contact} (4 bits), the turn of the last impact plus 1 (2
 * bits), whether the circle is pushed (1 bit), whether it settled (1 bit), and the exponent of the
 * largest speed (24 bits).
 */
public final class ContactWord {

  private static final int CONTACT = 15;
  private static final int TURN_SHIFT = 4;
  private static final int TURN = 3;
  private static final int PUSHED = 1 << 6;
  private static final int SETTLED = 1 << 7;
  private static final int EXPONENT_SHIFT = 8;

  private ContactWord() {}

  /** Encodes a circle's history of impacts with the contact of its next one. */
  static int of(MovingCircle m) {
    int flags = (m.pushed ? PUSHED : 0) | (m.settled ? SETTLED : 0);
    return m.speedExponent << EXPONENT_SHIFT | flags | (m.turn + 1) << TURN_SHIFT | m.contact;
  }

  /** The inverse of {@link #of}. */
  static void recall(int word, MovingCircle m) {
    m.contact = word & CONTACT;
    m.speedExponent = word >> EXPONENT_SHIFT;
    m.pushed = (word & PUSHED) != 0;
    m.settled = (word & SETTLED) != 0;
    m.turn = (word >> TURN_SHIFT & TURN) - 1;
  }
}
