// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

/**
 * The constants of contact. Units are the radius R of a circle, the size g of gravity, the length
 * tau of a tick, and the kick {@code g tau}. Sixteen numbers are the law, that of the solver and of
 * the search for flights included. The others follow from them.
 */
final class ContactLaw {

  // Ticks.

  /**
   * In radii: the distance that contacts keep, more than a solve errs by in one tick. With 2^-7
   * {@code ContactExactTest.aColumnPressesWithAllItsWeight} fails.
   */
  static final double STANDOFF = 0x1p-10;

  /**
   * A tick is about as long as a fall of so many radii: {@code tau = sqrt(2 FALL R / g)}. With 2^-7
   * {@code ContactExactTest.aBallRollsOffAPeg} fails.
   */
  static final double FALL = 2 * STANDOFF;

  /**
   * In kicks: slower approaches of what gravity presses together have no bounce. With 1 {@code
   * ContactExactTest.aColumnPressesWithAllItsWeight} fails.
   */
  static final double SLOW = 4;

  /**
   * Contacts within so many standoffs carry. With 2 a heap of 300 never rests, and {@code
   * ContactExactTest.aBallRollsOffAPeg} fails.
   */
  static final double HOLD = 8;

  /**
   * A solve may make so many sweeps, and as many more as it has fewer contacts: it may visit {@link
   * #WORK} of these. With 8 {@code ContactExactTest.aColumnPressesWithAllItsWeight} fails.
   */
  static final int SWEEPS = 40;

  static final int WORK = SWEEPS * SWEEPS;

  /**
   * So many times are flights that meet pushed apart, and so many times is a tick without safe
   * flights cut to a quarter. With 1 {@code ContactExactTest.theErrorIsOfSecondOrder} fails.
   */
  static final int TRIES = 4;

  /** Where there is no clock a solve may make so many sweeps. */
  static final int MOST_SWEEPS = TRIES * WORK;

  /**
   * In kicks: a solve ends when a sweep changes no velocity by more. With 0.1 {@code
   * ContactExactTest.aColumnPressesWithAllItsWeight} fails.
   */
  static final double RESIDUAL = 1e-3;

  /** In kicks: a change of momentum is an acceleration up to here, and beyond a hit. */
  static final double STEADY = SLOW / 2;

  /**
   * The first flight of a newcomer is no faster than this multiple of its speed, and slow. Without
   * a limit {@code ContactCasesTest.ballsFillAFloorExactly} fails, with 1 {@code
   * ContactExtremesTest.fullRows}.
   */
  static final double NEWCOMER = 1.5;

  // Rest.

  /**
   * A circle that is calm for so many of its own ticks freezes. With 1 {@code
   * ContactExactTest.aRowOnLevelGroundCollidesAsWithoutGravity} fails.
   */
  static final int CALM_TICKS = 16;

  /** In radii: a circle is calm as long as it stays within this distance. */
  static final double CALM_DISTANCE = STANDOFF / 4;

  /**
   * In kicks: a frozen circle wakes if it would move faster. With 0.001 heaps rest late, and {@code
   * ContactRestTest.aLandingBallWakesOnlyTheHeapItLandsOn} fails.
   */
  static final double WAKE = 0.1;

  // What moves.

  /**
   * In radii: the standoff of circles that a moving obstacle presses against another one. With
   * 2^-10 {@code ContactMoversTest.aPistonBucklesARow} fails.
   */
  static final double WIDE = 0x1p-5;

  // Impacts.

  /**
   * The number of impacts of one circle at one place after which it is stuck. With 400 {@code
   * ContactMoversTest.aPistonBucklesARow} fails.
   */
  static final int IMPACTS = 24;

  /**
   * At restitution 1 so many times more impacts at one place are possible. With 1 {@code
   * TrappedTest.aPocketOfSomeUlpsJams} fails.
   */
  static final int ELASTIC = 64;

  /**
   * In radii: the width of a place where impacts take motion away, and of a contact of circles.
   * With 2^-40 a gas that cools makes ten times the impacts, and {@code
   * InelasticTest.aGasThatCoolsGoesOn} fails.
   */
  static final double PLACE = 0x1p-16;

  /**
   * In radii: the width of a place for a circle that something pushes, the least standoff there. An
   * elastic one of speed v before something of speed u makes some {@code v / u} impacts while the
   * room halves.
   */
  static final double PUSHED = WIDE / 2;

  // Rounding.

  /**
   * In radii: a hop off a flat side that is lower is none. In coordinates: a way that is shorter
   * leaves a circle at one place. The sine of an angle that is none. With 2^-30 {@code
   * ContactCasesTest.disksOnAFloorThatShakesDoNotOverlap} fails.
   */
  static final double FLAT = 0x1p-40;

  /**
   * Masses in contact count as no more different, and no more is left of a load that was: an
   * impulse is rounded to 2^-53 of itself, which moves the lightest one by 2^-13 of what the
   * heaviest gets.
   */
  static final double MASS_RATIO = 1 / FLAT;

  /**
   * In ulps of the coordinates: a lower step, and a smaller gap at a joint, are none. With 0.5
   * {@code ContactExactTest.aRowOnLevelGroundCollidesAsWithoutGravity} fails.
   */
  static final double ULPS = 8;

  /** In units of the speed: an approach up to this is rounding, of two components. */
  static final double ROUNDED = 2 * ULPS * 0x1p-52;

  /** In units of the coordinates: what is nearer than some such steps touches. */
  static final double TOUCH = HOLD * ULPS * 0x1p-52;

  /**
   * In radii: flights may overlap by so much by rounding, which does not add up. With 2^-20 {@code
   * ContactCasesTest.disksOnAFloorThatShakesDoNotOverlap} fails.
   */
  static final double SLACK = HOLD * ULPS * FLAT;

  // The search for flights.

  /** Of the overlap with the standoff that flights take back in one tick. */
  static final double BACK = 1.0 / TRIES;

  /**
   * Squeezed circles fly aside between contacts whose normals have a cosine below this. Without
   * such flights {@code ContactMoversTest.aPistonPushesManyBalls} fails.
   */
  static final double OPPOSITE = -0.9;

  /**
   * So many times the speed of what moves is their speed aside: that of a circle between two sides
   * of such normals that close.
   */
  static final double ASIDE = Math.sqrt((1 - OPPOSITE) / (1 + OPPOSITE));

  // The list of pairs.

  /**
   * In radii: the margin within which pairs are listed, beside the ways of a tick. The widest
   * standoff is within it. With a wider one the list is longer, with a narrower one it is made more
   * often; with 2^-9 {@code ContactTurningTest.aWedgeThatClosesPushesABallOut} fails.
   */
  static final double MARGIN = 2 * WIDE;

  private ContactLaw() {}

  /**
   * How fast the gap to something that turns may bend, at most: its second derivative is {@code
   * -w^2 h + 2 w u - w' s} for the rate w, a centre at the height h over the pivot along the normal
   * and s across it, and its speed u across. Where all is 0 the radius r is the length that there
   * is.
   */
  static double bend(double rate, double faster, double r, double h, double s, double u) {
    return rate * rate * (r + Math.abs(h)) + 2 * Math.abs(rate * u) + Math.abs(faster * s);
  }
}
