// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

/**
 * The constants of contact. Units are the radius R of a circle, the size g of gravity, the length
 * tau of a tick, and the kick {@code g tau}.
 */
final class ContactLaw {

  /** A tick is about as long as a fall of so many radii: {@code tau = sqrt(2 FALL R / g)}. */
  static final double FALL = 0x1p-9;

  /** In kicks: slower approaches of what gravity presses together have no bounce. */
  static final double SLOW = 4;

  /** In radii: the distance that contacts keep, more than a solve errs by in one tick. */
  static final double STANDOFF = 0x1p-10;

  /** Contacts within so many standoffs carry. With 2 a heap of 300 never rests. */
  static final double HOLD = 8;

  /** A solve may make so many sweeps. */
  static final int SWEEPS = 40;

  /** A solve of few contacts may make more sweeps: so many over the number of contacts. */
  static final int WORK = 4000;

  /** In kicks: a solve ends when a sweep changes no velocity by more. */
  static final double RESIDUAL = 1e-3;

  /** In radii: a circle is calm as long as it stays within this distance. */
  static final double CALM_DISTANCE = 0x1p-12;

  /** A circle that is calm for so many of its own ticks freezes. */
  static final int CALM_TICKS = 16;

  /** In kicks: a frozen circle wakes if it would move faster. */
  static final double WAKE = 0.1;

  /** The first flight of a newcomer is no faster than this multiple of its speed, and slow. */
  static final double NEWCOMER = 1.5;

  /** In radii: the margin within which pairs are listed. */
  static final double MARGIN = 1 / 7.0;

  /** In ticks of its flight: the margin of a circle that is fast. */
  static final double MARGIN_TICKS = 2.2;

  /** Rounds in which flights push each other apart before they are shortened. */
  static final int PUSHES = 4;

  /** In radii: flights may overlap by so much by rounding, which does not add up. */
  static final double SLACK = 0x1p-34;

  /** In radii: the standoff of circles that a moving obstacle presses against another one. */
  static final double WIDE = 0x1p-5;

  /** Where no safe flights are found a tick is cut to a quarter, so many times. */
  static final int CUTS = 6;

  /**
   * Masses in contact count as no more different, and no more is left of a load that was: an
   * impulse is rounded to 2^-53 of itself, which moves the lightest one by 2^-13 of what the
   * heaviest gets.
   */
  static final double MASS_RATIO = 0x1p40;

  /**
   * In radii: a hop off a flat side that is lower is none. In coordinates: a way that is shorter
   * leaves a circle at one place. The sine of an angle that is none: a blow along a side leaves a
   * circle there.
   */
  static final double FLAT = 0x1p-40;

  /** The number of impacts of one circle at one place after which it is stuck. */
  static final int IMPACTS = 24;

  /** At restitutions from 1 on, so many times more impacts at one place are possible. */
  static final int ELASTIC = 64;

  /**
   * In radii: the width of a place for a circle that something pushes. An elastic one of speed v
   * before something of speed u makes some {@code v / u} impacts while the room halves.
   */
  static final double PUSHED = 0x1p-6;

  /** In radii: the width of a place where impacts take motion away, and of a contact of circles. */
  static final double PLACE = 0x1p-16;

  /** In units of the speed: an approach up to this is rounding, some ulps of the velocity. */
  static final double ROUNDED = 0x1p-48;

  /** In ulps of the coordinates: a lower step, and a smaller gap at a joint, are none. */
  static final double ULPS = 8;

  /** In units of the coordinates: what is as near as 64 ulps touches, or is at one place. */
  static final double TOUCH = 0x1p-46;

  private ContactLaw() {}
}
