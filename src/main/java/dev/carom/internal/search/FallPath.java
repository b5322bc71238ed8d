// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.MovingCircle;

/**
 * The path of a circle that falls or slides, and a straight band that the circle does not leave in
 * a piece of it. An obstacle outside of the band is not hit in the piece.
 *
 * <p>A piece of duration t bends away from its chord by at most {@code g t^2 / 8}, all to one side.
 * So it leaves the parallel halfway by at most {@code g t^2 / 16}, to either side.
 */
final class FallPath {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** In units of the terms of a place: far more than its rounding. */
  private static final double ROUNDING = 0x1p-40;

  /**
   * While the square of a reach is below this, no product overflows: a reach is at least 2^-40 of
   * each coordinate.
   */
  private static final double LARGEST_SQUARE = 0x1p200;

  /**
   * In cells: squares of speeds and accelerations below this do not overflow, and above its inverse
   * do not underflow.
   */
  private static final double FASTEST = 0x1p300;

  /** In cells: a place that is outside of the grid by less counts as inside. */
  private static final double NEAR = 0.25;

  /** The most cells that a piece may take, by its speed at the start. */
  private static final double MOST_CELLS = 0x1p14;

  /** The longest piece without acceleration: finite, so that its bend is 0 and not NaN. */
  private static final double LONGEST = 0x1p1000;

  private MovingCircle m;

  // The sizes of the coordinates and of the circle sum up to at most size + speed t + pull t^2.
  private double size;
  private double speed;
  private double pull;

  // The band: the start of its middle line, the way along that, and half its width.
  double bandX;
  double bandY;
  double alongX;
  double alongY;
  double reach;

  // The box around the circle in the piece.
  double left;
  double right;
  double bottom;
  double top;

  // The longest straight piece, kept, as nearly all circles have the same acceleration and grid.
  private double lastPull = Double.NaN;
  private double lastBend;
  private double longest;

  /** Takes the flight of a circle. */
  void start(MovingCircle circle) {
    m = circle;
    size = Math.abs(m.x) + Math.abs(m.y) + 2 * m.radius;
    speed = Math.abs(m.vx) + Math.abs(m.vy);
    pull = Math.abs(m.gx) + Math.abs(m.gy);
  }

  boolean isAtRest() {
    return speed == 0 && pull == 0;
  }

  // Where it is in a grid.

  /** Whether a grid resolves the path at a time. */
  boolean isResolved(Grid grid, double t) {
    double fastest = speed + pull * t;
    return grid.resolvesFall(size + fastest * t, fastest, pull);
  }

  /** Whether the centre is in a grid at a time. Up to {@link #NEAR} outside counts as inside. */
  boolean isInside(Grid grid, double t) {
    double column = grid.columns(place(m.x, m.vx, m.gx, t));
    double row = grid.rows(place(m.y, m.vy, m.gy, t));
    return column > -NEAR && column < grid.columns + NEAR && row > -NEAR && row < grid.rows + NEAR;
  }

  /**
   * The first time after another one, at which the centre is outside of a grid, when it crosses the
   * line of an edge and is then inside, or where its place is not resolved. Infinite if there is
   * none; NaN if a speed or an acceleration is so large or small that squares do not tell.
   */
  double entry(Grid grid, double after) {
    double scale = grid.perCell;
    if (!(isSquarable(m.vx * scale) && isSquarable(m.vy * scale))
        || !(isSquarable(m.gx * scale) && isSquarable(m.gy * scale))) {
      return Double.NaN;
    }
    double column = grid.columns(m.x);
    double row = grid.rows(m.y);
    double first = NEVER;
    first = entry(grid, -column, m.vx * scale, m.gx * scale, after, first);
    first = entry(grid, grid.columns - column, m.vx * scale, m.gx * scale, after, first);
    first = entry(grid, -row, m.vy * scale, m.gy * scale, after, first);
    return entry(grid, grid.rows - row, m.vy * scale, m.gy * scale, after, first);
  }

  private static boolean isSquarable(double speed) {
    double size = Math.abs(speed);
    return size == 0 || (size < FASTEST && size > 1 / FASTEST);
  }

  /**
   * The same for the line of one edge, d away on an axis; {@code first} if that is earlier. The
   * roots of {@code d = v t + g t^2 / 2} are {@code 2 d / q} and {@code -q / g}.
   */
  private double entry(Grid grid, double d, double v, double g, double after, double first) {
    double q = v + Math.copySign(Math.sqrt(v * v + 2 * g * d), v);
    double entry = isEntry(grid, 2 * d / q, after, first) ? 2 * d / q : first;
    return isEntry(grid, -q / g, after, entry) ? -q / g : entry;
  }

  private boolean isEntry(Grid grid, double t, double after, double first) {
    return t > after && t < first && (isInside(grid, t) || !isResolved(grid, t));
  }

  // Pieces and their bands.

  /**
   * Takes a piece that counts as straight in a grid, and its band. The piece lasts as long as is
   * wanted, but ends before it bends too much or takes more than {@link #MOST_CELLS}.
   *
   * @param wanted the duration that is wanted
   * @param cells the cells that are wanted, by the speed at the start, if that takes longer
   * @return the duration of the piece
   */
  double straighten(Grid grid, double from, double wanted, double cells) {
    double startVx = m.vx + m.gx * from;
    double startVy = m.vy + m.gy * from;
    double timePerCell = grid.cell / (Math.abs(startVx) + Math.abs(startVy));
    double enough = Math.max(wanted, cells * timePerCell);
    double duration = Math.min(longest(grid), Math.min(enough, MOST_CELLS * timePerCell));
    double part = duration / 16;
    double end = from + duration;
    alongX = (startVx + 0.5 * m.gx * duration) * duration;
    alongY = (startVy + 0.5 * m.gy * duration) * duration;
    bandX = place(m.x, m.vx, m.gx, from) - m.gx * duration * part;
    bandY = place(m.y, m.vy, m.gy, from) - m.gy * duration * part;
    reach = reach(pull * duration * part, end, grid.largestSum);
    box(bandX + alongX, bandY + alongY, reach, reach);
    return duration;
  }

  /** How long a piece lasts that bends as much as a grid allows. */
  private double longest(Grid grid) {
    if (pull != lastPull || grid.bend != lastBend) {
      lastPull = pull;
      lastBend = grid.bend;
      longest = Math.min(LONGEST, Math.sqrt(16 * grid.bend / pull));
    }
    return longest;
  }

  /** Half the width of a band, from whose middle line the path up to a time bends by so much. */
  private double reach(double bend, double end, double places) {
    return (m.radius + bend) * (1 + ROUNDING)
        + 4 * ROUNDING * (size + (speed + pull * end) * end + places);
  }

  /** Takes a piece, with its chord as the middle of the band. */
  void takeChord(double from, double end) {
    double duration = end - from;
    bandX = place(m.x, m.vx, m.gx, from);
    bandY = place(m.y, m.vy, m.gy, from);
    alongX = place(m.x, m.vx, m.gx, end) - bandX;
    alongY = place(m.y, m.vy, m.gy, end) - bandY;
    reach = reach(pull * (duration * duration) / 8, end, 0);
  }

  private void box(double endX, double endY, double marginX, double marginY) {
    left = Math.min(bandX, endX) - marginX;
    right = Math.max(bandX, endX) + marginX;
    bottom = Math.min(bandY, endY) - marginY;
    top = Math.max(bandY, endY) + marginY;
  }

  /** The same, and the box of the piece. */
  void takeChordAndBox(double from, double end) {
    takeChord(from, end);
    double turnsX = -m.vx / m.gx;
    double turnsY = -m.vy / m.gy;
    double marginX = margin(m.x, m.vx, m.gx, end < NEVER ? end : lastTurn(turnsX, from));
    double marginY = margin(m.y, m.vy, m.gy, end < NEVER ? end : lastTurn(turnsY, from));
    box(place(m.x, m.vx, m.gx, end), place(m.y, m.vy, m.gy, end), marginX, marginY);
    if (turnsX > from && turnsX < end) {
      double x = place(m.x, m.vx, m.gx, turnsX);
      left = Math.min(left, x - marginX);
      right = Math.max(right, x + marginX);
    }
    if (turnsY > from && turnsY < end) {
      double y = place(m.y, m.vy, m.gy, turnsY);
      bottom = Math.min(bottom, y - marginY);
      top = Math.max(top, y + marginY);
    }
    if (m.gx != 0 && turnsX == NEVER) { // it turns beyond the range of doubles
      left = -NEVER;
      right = NEVER;
    }
    if (m.gy != 0 && turnsY == NEVER) {
      bottom = -NEVER;
      top = NEVER;
    }
  }

  /** The last finite time at which an endless piece has a place: where it turns, or begins. */
  private static double lastTurn(double turn, double from) {
    return turn > from && turn < NEVER ? turn : from;
  }

  private double margin(double p, double v, double g, double t) {
    return m.radius + ROUNDING * (Math.abs(p) + 2 * m.radius + (Math.abs(v) + Math.abs(g) * t) * t);
  }

  /** The place on one axis, also after an infinite time. */
  private static double place(double p, double v, double g, double t) {
    if (t == NEVER) {
      double way = g != 0 ? g : v;
      return way == 0 ? p : way * NEVER;
    }
    return p + (v + 0.5 * g * t) * t;
  }

  // Tests of what may be hit in the piece.

  /** Whether the box around an obstacle is certainly out of reach. */
  boolean isBesideBox(double ax, double ay, double bx, double by, double radius) {
    return Math.min(ax, bx) - right > radius
        || left - Math.max(ax, bx) > radius
        || Math.min(ay, by) - top > radius
        || bottom - Math.max(ay, by) > radius;
  }

  /**
   * Whether an obstacle from a to b is certainly outside of the band. Either both its ends are on
   * one side of the band, or both ends of the band are on one side of the obstacle.
   */
  boolean isBeside(double ax, double ay, double bx, double by, double radius) {
    double places = Math.abs(ax) + Math.abs(ay) + Math.abs(bx) + Math.abs(by);
    double total = reach + radius + ROUNDING * places;
    double square = total * total;
    if (!(square > Double.MIN_NORMAL && square < LARGEST_SQUARE)) {
      return false; // so small or large that squares do not tell
    }
    double dx = ax - bandX;
    double dy = ay - bandY;
    double a = alongX * dy - alongY * dx;
    double b = alongX * (by - bandY) - alongY * (bx - bandX);
    double wx = bx - ax;
    double wy = by - ay;
    double first = wy * dx - wx * dy;
    double last = first + (wx * alongY - wy * alongX);
    double besideBand = beyond(a, b, square * lengthSquare(alongX, alongY));
    double besideObstacle = beyond(first, last, square * lengthSquare(wx, wy));
    // One branch for both, as each alone would be unpredictable.
    return (Double.doubleToRawLongBits(besideBand) | Double.doubleToRawLongBits(besideObstacle))
        < 0;
  }

  /** Not less than the square of a length; the least normal number covers underflow. */
  private static double lengthSquare(double x, double y) {
    return x * x + y * y + Double.MIN_NORMAL;
  }

  /**
   * Negative if two numbers have one sign, and both their squares are above a limit; branch-free.
   * Its rounding, 4 ulps of the larger number, is far below the {@link #ROUNDING} in the reach.
   */
  private static double beyond(double a, double b, double limit) {
    double twice =
        Math.abs(a + b) - Math.abs(a - b); // twice the lesser size; below 0 if the signs differ
    return 4 * limit + Double.MIN_NORMAL - twice * Math.abs(twice);
  }
}
