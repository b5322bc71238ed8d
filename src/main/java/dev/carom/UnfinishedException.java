// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * An {@code UnfinishedException} says that a call spent its budget of work before the {@link World}
 * had all impacts up to the time that was asked for.
 *
 * <p>Nothing is lost: the world is whole, and its log holds the impacts of the part that was done.
 * The same call again goes on from there with a new budget. Its causes, and what to do, stand in <a
 * href="doc-files/rules.html#unfinished">Rules and limits</a>. A program that expects such calls
 * bounds them with {@link World#advanceTo(double, long) World.advanceTo(t, work)}, which throws
 * nothing.
 */
public final class UnfinishedException extends RuntimeException {

  private static final long serialVersionUID = 1;

  /** The id of the circle. */
  private final int circle;

  UnfinishedException(double reached, double asked, int circle) {
    super(
        ("the budget of work was spent at time %s, before all impacts until %s, most of it by circle"
                + " %s: call again to go on, move or remove the circle, or bound each call by"
                + " advanceTo(t, work)")
            .formatted(reached, asked, circle));
    this.circle = circle;
  }

  /**
   * Returns the circle that spent most of the budget. Where circles collide, it is the one with the
   * most impacts. Where they ignore each other, it is the first one that spent the work it may do.
   *
   * @return its id
   */
  public int circle() {
    return circle;
  }
}
