// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.MovingCircle;

/**
 * The path of a circle that falls or slides, and a straight line near a piece of it. What is out of
 * reach of that line is not hit in the piece.
 *
 * <p>From its chord, a piece of length t bends by at most {@code g t^2 / 8}, all to one side. From
 * the line halfway between it bends by {@code g t^2 / 16} to either side.
 */
final class FallPath {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** In units of the terms of a place: far more than its rounding. */
  private static final double ROUNDING = 0x1p-40;

  /** If the square of a reach, which covers rounding, is below this, no product overflows. */
  private static final double LARGEST_SQUARE = 0x1p200;

  /** In cells and their inverse: squares of speeds and accelerations between do not overflow. */
  private static final double FASTEST = 0x1p300;

  /** In cells: a place that is outside of the grid by less counts as inside. */
  private static final double NEAR = 0.25;

  /** The most cells that a piece may take, by its speed at the start. */
  private static final double MOST_CELLS = 0x1p14;

  private static final double LONGEST = 0x1p1000;

  // The path.
  private double px;
  private double py;
  private double vx;
  private double vy;
  private double gx;
  private double gy;
  private double r;

  // What bounds a coordinate: size + speed t + pull t^2.
  private double size;
  private double speed;
  private double pull;

  // The line: its start, the way along it, and how far the circle reaches from it in the piece.
  double lineX;
  double lineY;
  double alongX;
  double alongY;
  double reach;

  // The box around the circle in the piece.
  double left;
  double right;
  double bottom;
  double top;

  // The longest piece that counts as straight, for the last acceleration and grid asked about.
  private double lastPull = Double.NaN;
  private double lastBend;
  private double longest;

  /** Takes the flight of a circle. */
  void start(MovingCircle m) {
    px = m.x;
    py = m.y;
    vx = m.vx;
    vy = m.vy;
    gx = m.gx;
    gy = m.gy;
    r = m.radius;
    size = Math.abs(px) + Math.abs(py) + 2 * r;
    speed = Math.abs(vx) + Math.abs(vy);
    pull = Math.abs(gx) + Math.abs(gy);
  }

  boolean isInRange() {
    return Math.abs(px) <= Double.MAX_VALUE && Math.abs(py) <= Double.MAX_VALUE;
  }

  boolean isAtRest() {
    return speed == 0 && pull == 0;
  }

  // Where it is in a grid.

  /** Whether the cell is known at a time. */
  boolean isResolved(Grid grid, double t) {
    double fastest = speed + pull * t;
    return grid.follows(size + fastest * t, fastest, pull);
  }

  /** Whether the centre is inside of a grid at a time, or almost. */
  boolean isInside(Grid grid, double t) {
    double column = grid.columns(place(px, vx, gx, t));
    double row = grid.rows(place(py, vy, gy, t));
    return column > -NEAR && column < grid.columns + NEAR && row > -NEAR && row < grid.rows + NEAR;
  }

  /**
   * The next time after another, at which the centre is outside of a grid, when it comes in, or is
   * where that is not known any more; NaN if speeds are so large or small that this does not tell.
   */
  double entry(Grid grid, double after) {
    double scale = grid.perCell;
    if (!(isInRange(vx * scale) && isInRange(vy * scale))
        || !(isInRange(gx * scale) && isInRange(gy * scale))) {
      return Double.NaN;
    }
    double column = grid.columns(px);
    double row = grid.rows(py);
    double first = NEVER;
    first = entry(grid, -column, vx * scale, gx * scale, after, first);
    first = entry(grid, grid.columns - column, vx * scale, gx * scale, after, first);
    first = entry(grid, -row, vy * scale, gy * scale, after, first);
    return entry(grid, grid.rows - row, vy * scale, gy * scale, after, first);
  }

  private static boolean isInRange(double speed) {
    double size = Math.abs(speed);
    return size == 0 || (size < FASTEST && size > 1 / FASTEST);
  }

  /** The same over an edge of the grid, d away on an axis, unless another entry is before it. */
  private double entry(Grid grid, double d, double v, double g, double after, double first) {
    double q = v + Math.copySign(Math.sqrt(v * v + 2 * g * d), v);
    double entry = isEntry(grid, 2 * d / q, after, first) ? 2 * d / q : first;
    return isEntry(grid, -q / g, after, entry) ? -q / g : entry;
  }

  private boolean isEntry(Grid grid, double t, double after, double first) {
    return t > after && t < first && (isInside(grid, t) || !isResolved(grid, t));
  }

  // Pieces and the lines near them.

  /**
   * Takes a piece that counts as straight in a grid, and the line halfway between it and its chord.
   *
   * @param needed the length of the piece that is wanted in any case
   * @param cells the number of cells that are wanted in any case
   * @return the length of the piece
   */
  double straighten(Grid grid, double from, double needed, int cells) {
    double startVx = vx + gx * from;
    double startVy = vy + gy * from;
    double perCell = grid.cell / (Math.abs(startVx) + Math.abs(startVy));
    double wanted = Math.max(needed, cells * perCell);
    double length = Math.min(longest(grid), Math.min(wanted, MOST_CELLS * perCell));
    double part = length / 16;
    double end = from + length;
    alongX = (startVx + 0.5 * gx * length) * length;
    alongY = (startVy + 0.5 * gy * length) * length;
    lineX = place(px, vx, gx, from) - gx * length * part;
    lineY = place(py, vy, gy, from) - gy * length * part;
    reach = reach(pull * length * part, end, grid.extent);
    box(lineX + alongX, lineY + alongY, reach, reach);
    return length;
  }

  /** The length of a piece that bends as much as a grid allows. */
  private double longest(Grid grid) {
    if (pull != lastPull || grid.bend != lastBend) {
      lastPull = pull;
      lastBend = grid.bend;
      longest = Math.min(LONGEST, Math.sqrt(16 * grid.bend / pull));
    }
    return longest;
  }

  /** How far the circle reaches from a line, from which its path up to a time bends. */
  private double reach(double bend, double end, double places) {
    return (r + bend) * (1 + ROUNDING)
        + 4 * ROUNDING * (size + (speed + pull * end) * end + places);
  }

  /** Takes a piece and its chord. */
  void draw(double from, double end) {
    double length = end - from;
    lineX = place(px, vx, gx, from);
    lineY = place(py, vy, gy, from);
    alongX = place(px, vx, gx, end) - lineX;
    alongY = place(py, vy, gy, end) - lineY;
    reach = reach(pull * (length * length) / 8, end, 0);
  }

  private void box(double endX, double endY, double marginX, double marginY) {
    left = Math.min(lineX, endX) - marginX;
    right = Math.max(lineX, endX) + marginX;
    bottom = Math.min(lineY, endY) - marginY;
    top = Math.max(lineY, endY) + marginY;
  }

  /** Takes a piece, its chord and its box. */
  void enclose(double from, double end) {
    draw(from, end);
    double turnsX = -vx / gx;
    double turnsY = -vy / gy;
    double marginX = margin(px, vx, gx, end < NEVER ? end : lastTurn(turnsX, from));
    double marginY = margin(py, vy, gy, end < NEVER ? end : lastTurn(turnsY, from));
    box(place(px, vx, gx, end), place(py, vy, gy, end), marginX, marginY);
    if (gx != 0 && turnsX == NEVER) { // it turns beyond the range of doubles
      left = -NEVER;
      right = NEVER;
    }
    if (gy != 0 && turnsY == NEVER) {
      bottom = -NEVER;
      top = NEVER;
    }
    if (turnsX > from && turnsX < end) {
      double x = place(px, vx, gx, turnsX);
      left = Math.min(left, x - marginX);
      right = Math.max(right, x + marginX);
    }
    if (turnsY > from && turnsY < end) {
      double y = place(py, vy, gy, turnsY);
      bottom = Math.min(bottom, y - marginY);
      top = Math.max(top, y + marginY);
    }
  }

  /** The last finite time at which an endless piece has a place: where it turns, or begins. */
  private static double lastTurn(double turn, double from) {
    return turn > from && turn < NEVER ? turn : from;
  }

  private double margin(double p, double v, double g, double t) {
    return r + ROUNDING * (Math.abs(p) + 2 * r + (Math.abs(v) + Math.abs(g) * t) * t);
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

  /** Whether a box is certainly out of reach. */
  boolean isBesideBox(double ax, double ay, double bx, double by, double radius) {
    return Math.min(ax, bx) - right > radius
        || left - Math.max(ax, bx) > radius
        || Math.min(ay, by) - top > radius
        || bottom - Math.max(ay, by) > radius;
  }

  /**
   * Whether an obstacle from a to b is certainly out of reach: both its ends lie on one side of the
   * line near the piece, or both ends of that on one side of it.
   */
  boolean isBeside(double ax, double ay, double bx, double by, double radius) {
    double places = Math.abs(ax) + Math.abs(ay) + Math.abs(bx) + Math.abs(by);
    double total = reach + radius + ROUNDING * places;
    double square = total * total;
    if (!(square > Double.MIN_NORMAL && square < LARGEST_SQUARE)) {
      return false; // so small or large that squares do not tell
    }
    double dx = ax - lineX;
    double dy = ay - lineY;
    double a = alongX * dy - alongY * dx;
    double b = alongX * (by - lineY) - alongY * (bx - lineX);
    double wx = bx - ax;
    double wy = by - ay;
    double first = wy * dx - wx * dy;
    double last = first + (wx * alongY - wy * alongX);
    double besidePath = beyond(a, b, square * lengthSquare(alongX, alongY));
    double besideObstacle = beyond(first, last, square * lengthSquare(wx, wy));
    // One branch for both, as each alone would be unpredictable.
    return (Double.doubleToRawLongBits(besidePath) | Double.doubleToRawLongBits(besideObstacle))
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
    double twice = Math.abs(a + b) - Math.abs(a - b); // the lesser size, below 0 for two signs
    return 4 * limit + Double.MIN_NORMAL - twice * Math.abs(twice);
  }
}
