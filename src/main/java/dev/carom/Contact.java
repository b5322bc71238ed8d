// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.util.Check;

/**
 * Something with which a circle is in contact, see {@link World#contacts}.
 *
 * @param kind the kind of the thing
 * @param id its id; of a wall 0 left, 1 right, 2 bottom, 3 top
 * @param part of an {@link Outline} the number of the side, 0 of all else
 * @param nx the x component of the unit normal, which points from the thing to the circle
 * @param ny the y component of the unit normal
 */
public record Contact(Kind kind, int id, int part, double nx, double ny) {

  /**
   * Makes an answer.
   *
   * @param kind the kind of the thing
   * @param id its id
   * @param part the side of an outline, else 0
   * @param nx the x component of the unit normal
   * @param ny the y component of the unit normal
   * @throws NullPointerException if the kind is null
   */
  public Contact {
    Check.notNull("kind", kind);
  }
}
