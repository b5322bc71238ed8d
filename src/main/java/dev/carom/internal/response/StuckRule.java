// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.state.MovingCircle;

/**
 * Counts the impacts of a circle at one place, and decides when it is stuck.
 *
 * <p>Restitution other than 1, or clearance below rounding, can make infinitely many impacts in
 * finite time. Two successive impacts are at one place if the circle and its partner moved next to
 * nothing between them. A circle is <i>stuck</i> when the weights of its successive impacts at one
 * place exceed {@link #LIMIT}; from then on its impacts there have restitution 0.
 *
 * <ul>
 *   <li><b>Elastic impacts.</b> A place is 2^-39 of the coordinates wide: doubles hold so small a
 *       clearance to four digits only. 1,024 impacts with obstacles make a circle stuck, or 16,384
 *       with circles: long elastic rows need that many.
 *   <li><b>Other impacts.</b> A place is at least 2^-16 of the radius wide. The weight of an impact
 *       follows its restitution: a circle is stuck when the product of the restitutions is below
 *       2^-16, or above 2^16, but after more than 4 impacts. Then the impacts took away nearly all
 *       of the motion, or made nearly all of it.
 *   <li><b>Faint impacts</b> weigh 1/32 of the limit. Their approach is no more than the rounding
 *       of the speeds met at that place.
 *   <li><b>Pushed circles.</b> An infinite mass or a moving obstacle that pushes a circle against
 *       another thing leaves it less room with each impact: infinitely many impacts, even at
 *       restitution 1. For such a circle 2^-10 of the radius is one place, or 2^-6 in scenes with
 *       moving obstacles.
 * </ul>
 */
public final class StuckRule {

  /** The sum of weights beyond which a circle is stuck. */
  public static final int LIMIT = MovingCircle.STUCK_LIMIT;

  /** The weight of an elastic impact with an obstacle. */
  public static final int ELASTIC = LIMIT / 1024;

  /** The weight of an elastic impact with a circle of finite mass. */
  public static final int ELASTIC_PAIR = LIMIT / 16_384;

  /** The weight of an impact that halves or doubles the speed along the normal. */
  private static final int HALVING = LIMIT / 16;

  /** The most that an impact weighs. */
  private static final int HEAVIEST = LIMIT / 4;

  /** The weight of an impact that approaches by no more than rounding. */
  private static final int FAINT = LIMIT / 32;

  private static final double LN_2 = 0.6931471805599453;

  /** The width of a place, as a part of the circle's coordinates. */
  private static final double PLACE = 0x1p-39;

  /** The least width of a place where impacts are not elastic, as a part of the radius. */
  static final double INELASTIC_PLACE = 0x1p-16;

  /** The width of a place for a circle that an infinite mass pushes, in radii. */
  static final double PUSHED_PLACE = 0x1p-10;

  /**
   * The same for a circle that a moving obstacle pushes. An elastic circle of speed v between an
   * obstacle of speed u and something at rest makes some {@code v / u} impacts while the gap
   * halves, and twice as many with each further half.
   */
  private static final double MOVED_PLACE = 0x1p-6;

  /** The part of its coordinates by which rounding can move a circle: 4 ulps of 1..2 are 2^-50. */
  private static final double ROUNDED = 0x1p-51;

  /** An approach up to this part of the speed is rounding: some ulps of the velocity. */
  static final double ROUNDED_SPEED = 0x1p-48;

  private StuckRule() {}

  /**
   * Counts an impact.
   *
   * @param flown how long the circle flew since its last impact; 0 if too short to advance the
   *     clock
   * @param relative the sum of the absolute components of its velocity relative to its partner
   * @param speed the same sum of both velocities, or more
   * @param approach the speed along the normal
   * @param e the restitution
   * @param elastic the weight of an impact of restitution 1
   * @param pushed the width of a place for a pushed circle, in radii
   */
  static void count(
      MovingCircle m,
      double flown,
      double relative,
      double speed,
      double approach,
      double e,
      int elastic,
      double pushed) {
    double way = flown * relative;
    int exponent = exponent(speed);
    if (hasLeft(m, way) && !isFaint(approach, exponent)) { // the usual case
      m.leavePlace();
      m.speedExponent = exponent;
    } else if (way <= place(m, e) || slides(m, flown, approach, exponent)) {
      m.speedExponent = Math.max(m.speedExponent, exponent);
      add(m, isFaint(m, approach) ? FAINT : weight(e, elastic));
    } else if (m.pushed && way <= pushed * m.radius) {
      m.speedExponent = Math.max(m.speedExponent, exponent);
      add(m, weight(e, elastic));
    } else {
      m.leavePlace();
      m.speedExponent = exponent;
    }
  }

  /** The width of a place for a pushed circle, in radii, by whether any obstacle moves. */
  static double pushedPlace(boolean isAnyMoving) {
    return isAnyMoving ? MOVED_PLACE : PUSHED_PLACE;
  }

  /** Whether a circle slid along its partner: they came nearer by no more than rounding. */
  private static boolean slides(MovingCircle m, double flown, double approach, int exponent) {
    return isFaint(approach, exponent)
        && (isStuck(m) || flown * Math.abs(approach) <= ROUNDED * size(m));
  }

  /**
   * Whether a circle certainly left its last place: it moved farther than a place of any kind is
   * wide. Most circles did, and the width of their own place need not be known.
   */
  private static boolean hasLeft(MovingCircle m, double way) {
    double widest = fma(PLACE, Math.abs(m.x) + Math.abs(m.y), MOVED_PLACE * m.radius);
    return way > widest;
  }

  private static void add(MovingCircle m, int weight) {
    m.stuck = Math.min(m.stuck + weight, LIMIT + 1);
  }

  /** The weight of an impact; if it is not elastic, by the halvings or doublings of the speed. */
  private static int weight(double e, int elastic) {
    double halvings = e == 1 ? 0 : Math.abs(StrictMath.log(e)) / LN_2;
    return (int) Math.max(elastic, Math.min(HEAVIEST, halvings * HALVING));
  }

  /** The width of a place. */
  private static double place(MovingCircle m, double e) {
    double place = PLACE * size(m);
    return e == 1 ? place : Math.max(place, INELASTIC_PLACE * m.radius);
  }

  private static double size(MovingCircle m) {
    return Math.max(Math.max(Math.abs(m.x), Math.abs(m.y)), m.radius);
  }

  /** The distance from the last impact within which a circle is still at the same place. */
  static double widthOfPlace(MovingCircle m) {
    return isStuck(m) ? place(m, 0) : ROUNDED * size(m);
  }

  /** Whether a circle is stuck: its impacts at one place exceed the limit. */
  static boolean isStuck(MovingCircle m) {
    return m.stuck > LIMIT;
  }

  /** Notes a speed that occurred at the place of a circle. */
  static void noteSpeed(MovingCircle m, double speed) {
    m.speedExponent = Math.max(m.speedExponent, exponent(speed));
  }

  /** Whether an approach is no more than rounding of the speeds that a circle met at its place. */
  static boolean isFaint(MovingCircle m, double approach) {
    return isFaint(approach, m.speedExponent);
  }

  /** Whether an approach is no more than rounding of a speed. */
  static boolean isFaint(double approach, double speed) {
    return isFaint(approach, exponent(speed));
  }

  private static boolean isFaint(double approach, int exponent) {
    return Math.abs(approach) <= ROUNDED_SPEED * powerOfTwo(exponent);
  }

  /** The binary exponent of a speed. */
  private static int exponent(double speed) {
    return Math.min(Math.getExponent(speed), Double.MAX_EXPONENT);
  }

  /** 2^k for the exponent k of a double; 0 and subnormal numbers have the exponent -1023. */
  private static double powerOfTwo(int k) {
    return k < Double.MIN_EXPONENT
        ? Double.MIN_NORMAL / 2
        : Double.longBitsToDouble((long) (k + Double.MAX_EXPONENT) << 52);
  }
}
