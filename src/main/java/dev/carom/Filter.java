// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.FilterBits;
import dev.carom.internal.util.Check;

/**
 * A {@code Filter} says what a thing can meet: its category and its mask, each a set of 32 bits.
 *
 * <p>Two things meet if the mask of each has a bit of the other's category: {@code (a.category &
 * b.mask) != 0 && (b.category & a.mask) != 0}. Other pairs do not exist for each other. They make
 * no impact, a sensor does not report them, and {@link Scene#warnings} is silent about them.
 *
 * <pre>{@code
 * final Filter GHOST = new Filter(4, -1);
 * Scene scene = Scene.builder()
 *     .bounds(0, 0, 100, 100)
 *     .line(50, 0, 50, 100).filter(new Filter(1, ~4))
 *     .circle(20, 30, 5, 1, 0) // bounces off the line
 *     .circle(20, 70, 5, 1, 0).filter(GHOST) // flies through it
 *     .build();
 * System.out.println(scene.traits(Kind.CIRCLE, 1).filter().category()); // 4
 * }</pre>
 *
 * @param category the categories that the thing belongs to; 0 for a thing that meets nothing
 * @param mask the categories that it can meet; 0 for a thing that meets nothing
 */
public record Filter(int category, int mask) {

  /** Category 1, and all bits in the mask: the filter of things and questions without another. */
  public static final Filter DEFAULT = new Filter(1, -1);

  /** All bits in both: a question with this filter sees all that anything can meet. */
  public static final Filter ALL = new Filter(-1, -1);

  /** Returns the filter with a given code, see {@link FilterBits}. */
  static Filter of(long bits) {
    return new Filter(FilterBits.category(bits), FilterBits.mask(bits));
  }

  /** Returns the code of this filter, see {@link FilterBits}. */
  long bits() {
    return FilterBits.of(category, mask);
  }

  /**
   * Tells whether two things can meet.
   *
   * @param other the filter of the other thing
   * @return whether the mask of each has a bit of the other's category
   */
  public boolean meets(Filter other) {
    return FilterBits.meet(bits(), Check.notNull("other", other).bits());
  }
}
