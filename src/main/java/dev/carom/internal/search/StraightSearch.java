// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.FallSweep;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.sweep.PointSweep;
import dev.carom.internal.sweep.SegmentFilter;
import dev.carom.internal.sweep.SideSweep;
import dev.carom.internal.sweep.UnitVectors;
import dev.carom.internal.sweep.WallSweep;

/**
 * Finds the next impact of a circle that flies straight on. The filter in plain doubles answers
 * most questions about lines, with a rough time. The exact time is computed for the first impact
 * only.
 */
final class StraightSearch extends CellWalk {

  /** The margin of the lists covers this part of a cell beyond the visited ones. */
  private static final double NEAR_CELLS = 0x1p-10;

  /** Far more than the rounding of a place, in units of its terms. */
  private static final double ROUNDING = 0x1p-40;

  /** Least speed, and least speed times size, for which the bounds cover underflow. */
  private static final double LEAST_SAFE = 0x1p-900;

  /** No overflow up to this: a sum of two cross products is at most 8 times as large. */
  private static final double MOST_SAFE = 0x1p1020;

  private final double[] walls;

  /** The largest finite coordinate of the bounds, and that of the lines and pegs. */
  private final double extentOfBounds;

  double extent;

  /** The {@link SegmentFilter#margin} of all lines. */
  private double margin;

  /** Whether the best time is the estimate of {@link SegmentFilter}. */
  private boolean isRough;

  /** A circle whose centre is further than this from a wall certainly does not touch it. */
  private double inset;

  /**
   * A time at or shortly before the impact with the next wall on each axis. The impact itself is
   * computed only if nothing comes before.
   */
  private double aheadX;

  private double aheadY;

  StraightSearch(ObstacleTable obstacles, CodeSet loose) {
    super(obstacles, loose);
    walls = obstacles.walls;
    extentOfBounds = obstacles.extentOfBounds();
  }

  @Override
  void start(MovingCircle m) {
    super.start(m);
    unhittable = m.last; // it is convex
    spared = m.last;
    isRough = false;
  }

  @Override
  void forgetHits() {
    unhittable = MovingCircle.NOTHING;
    jam = null;
    sensed = -1;
  }

  private boolean isAtRest() {
    return vx == 0 && vy == 0;
  }

  @Override
  double search(Grid grid, double needed) {
    if (isAtRest()) {
      return NEVER;
    }
    measure();
    double ahead = wallAhead();
    // The last cell before the wall is visited in any case, and its list reaches up to the wall.
    double known = explore(grid, Math.min(body.cleared, ahead), needed, ahead);
    if (known >= ahead) {
      considerWalls();
      known = best;
      if (grid != null && isFar(ahead, grid)) {
        known = explore(grid, Math.max(body.cleared, ahead), needed, best);
      }
    }
    return known;
  }

  /**
   * Whether the first impact found is so much later than the estimated time of the wall that the
   * walk skipped cells between. A circle that all but touches a wall and drifts towards it slowly
   * needs this.
   */
  private boolean isFar(double ahead, Grid grid) {
    return (best - ahead) * manhattanSpeed > NEAR_CELLS * grid.cell;
  }

  /**
   * Searches lines and pegs; returns the time until which the path is known, or that of the wall
   * ahead.
   */
  private double explore(Grid grid, double from, double needed, double ahead) {
    if (grid != null && grid.resolves(px, py, manhattanSpeed)) {
      considerLoose();
      return walk(grid, from, needed, ahead);
    }
    if (obstacles.size() == 0) {
      return ahead;
    }
    considerEach();
    settle();
    return best;
  }

  /** Walks until the path is known for some cells beyond the needed time. */
  private double walk(Grid grid, double from, double needed, double ahead) {
    int halvesOfCells = body.useLookahead();
    double start = grid.contains(px, py) ? from : grid.entry(px, py, vx, vy, from);
    // The estimated time of a wall that is all but touched is 0, but another obstacle that the
    // circle touches may come before it.
    if (!(start <= ahead) || start == NEVER) {
      settle();
      return Math.min(best, ahead);
    }
    double x = grid.columns(px);
    double y = grid.rows(py);
    if (start != 0) { // else the first cell is known before v is
      x = grid.columns(fma(vx, start, px));
      y = grid.rows(fma(vy, start, py));
    }
    double rate = ticks(grid);
    // Two ticks beyond: one may be lost where times are cut to ticks.
    double most = Math.max((needed - start) * rate, halvesOfCells * (TICKS / 2)) + 2;
    return walk(grid, x, y, start, rate, most, ahead);
  }

  /** Computes the error bounds of the flight from its speed and size. */
  private void measure() {
    double absVx = Math.abs(vx);
    double absVy = Math.abs(vy);
    head(vx, vy, absVx + absVy);
    double length = UnitVectors.lengthBound(absVx, absVy);
    // cross(a - p, v) errs by at most 4 u of the terms of cross(p, v), 3 u of |ax vy| and 2 u of
    // |ay vx|, u = 2^-53: by 4 u |v| times the size below, as 3^2 + 2^2 < 4^2. Sum and difference
    // of two, by twice that and their rounding, 11 u; with 2 r |v| and its sum, 14 u more: 36 u in
    // all, 64 are left for them.
    double size = Math.abs(px) + Math.abs(py) + Math.max(extent, extentOfBounds) + r;
    double scale = length * size;
    boolean ordinary = manhattanSpeed > LEAST_SAFE && scale > LEAST_SAFE && scale < MOST_SAFE;
    inset = ordinary ? r + fma(0x1p-48, size, Double.MIN_NORMAL) : NEVER;
    clear = ordinary ? 2 * length * inset : NEVER;
    crossX = ordinary ? vy : 0;
    crossY = ordinary ? 0 - vx : 0;
    crossOfOrigin = ordinary ? py * vx - px * vy : 0;
    double ofAll = SegmentFilter.margin(length, size);
    margin = jam != null ? ofAll + NEVER : ofAll;
  }

  /** A time at or shortly before the impact with the next wall. */
  private double wallAhead() {
    if (!bounded) {
      return NEVER;
    }
    // Distances from the walls ahead, branch-free. They err by less
    // than 16 u of the size, reciprocals and products included.
    double x = Math.copySign(1, vx) * (walls[ahead(Codes.LEFT, vx)] - px);
    double y = Math.copySign(1, vy) * (walls[ahead(Codes.BOTTOM, vy)] - py);
    aheadX = (x - inset) * perVx;
    aheadY = (y - inset) * perVy;
    double t = Math.min(aheadX, aheadY);
    return t > 0 ? t : 0; // NaN if a distance is beyond the doubles
  }

  /** The code of the wall that v, which may be 0 of either sign, points to. */
  private static int ahead(int lowCode, double v) {
    return lowCode + 1 - (int) (Double.doubleToRawLongBits(v) >>> 63);
  }

  /** Considers the two walls ahead; the one that is later by estimate only if it may come first. */
  private void considerWalls() {
    if (bounded) {
      boolean isVerticalFirst = aheadX < aheadY;
      considerWall(isVerticalFirst);
      if (!(Math.max(aheadX, aheadY) > best)) {
        considerWall(!isVerticalFirst);
      }
    }
  }

  // Obstacles at rest.

  @Override
  void consider(int code) {
    if (!Codes.isLine(code)) {
      considerOnly(code);
    } else if (near(CellList.pair(code, code)) != 0) {
      look(code);
    }
  }

  @Override
  void considerOnly(int code) {
    if (code != bestCode && !obstacles.isGone(code) && !isAtRest() && !ignores(code)) {
      fly();
      choose(code);
      ask(code, NEVER);
    }
  }

  /** Sets the flight of the questions to the detector; most flights need none. */
  private void fly() {
    fall.flight(px, py, r, vx, vy, 0, 0);
  }

  /** Asks for an impact with the obstacle chosen, up to the rounding of a time. */
  private void ask(int code, double end) {
    if (special && obstacles.isOneWay(code) && !OneWay.stops(fall)) {
      return;
    }
    int contact = FallSweep.straightContact(fall);
    if (contact != Contact.MISS) {
      double t = FallSweep.straightTime(fall, contact, Math.nextUp(end));
      if (!special || counts(code, contact, t)) {
        offer(t, code, contact);
      }
    }
  }

  /** Considers the wall that the circle moves towards, of the vertical or of the other ones. */
  private void considerWall(boolean vertical) {
    double v = vertical ? vx : vy;
    int code = ahead(vertical ? Codes.LEFT : Codes.BOTTOM, v);
    double t = WallSweep.time(vertical ? px : py, r, v, obstacles.walls[code]);
    if (!ignores(code)) {
      offer(t, code, 0);
    }
  }

  /** Considers a line; the segment filter alone decides nearly always. */
  @Override
  void look(int code) {
    if (code == bestCode || isFiltered(code)) {
      return;
    }
    int k = code * LineShape.ROW;
    double ax = lines[k + LineShape.AX];
    double ay = lines[k + LineShape.AY];
    double bx = lines[k + LineShape.BX];
    double by = lines[k + LineShape.BY];
    int contact = SegmentFilter.contact(px, py, r, vx, vy, ax, ay, bx, by, margin);
    if (contact > Contact.MISS && special && obstacles.traits(code) != 0) {
      considerOnly(code);
    } else if (contact > Contact.MISS) {
      keepRough(SegmentFilter.time(contact, px, py, r, vx, vy, ax, ay, bx, by), code, contact);
    } else if (contact == Contact.DOUBT) {
      considerOnly(code);
    }
  }

  /** Keeps a contact whose time is rough, unless an earlier impact is certain. */
  private void keepRough(double t, int code, int contact) {
    double after = t * (1 + SegmentFilter.TIME_ERROR);
    if (after < best) {
      best = t;
      latest = after;
      isRough = true;
      bestCode = code;
      bestContact = contact;
    } else if (t * (1 - SegmentFilter.TIME_ERROR) <= latest) { // latest may be exact
      offer(timeOf(code, contact, t), code, contact);
    }
  }

  @Override
  void settle() {
    if (isRough) {
      isRough = false;
      best = timeOf(bestCode, bestContact, best);
      latest = best;
    }
  }

  /** The exact time of a contact with a line, from the rough one. */
  private double timeOf(int line, int contact, double rough) {
    int k = line * LineShape.ROW;
    if (contact >= Contact.START) {
      // A branch on the end would be unpredictable, so the index is computed without one.
      int end = k + (contact - Contact.START) * LineShape.END;
      double x = lines[end + LineShape.AX];
      double y = lines[end + LineShape.AY];
      return PointSweep.time(px, py, r, vx, vy, x, y, rough);
    }
    int side = contact == Contact.LEFT ? 1 : -1;
    double ax = lines[k + LineShape.AX];
    double ay = lines[k + LineShape.AY];
    double bx = lines[k + LineShape.BX];
    double by = lines[k + LineShape.BY];
    return SideSweep.refined(side, px, py, r, vx, vy, ax, ay, bx, by, 0, 0, rough, NEVER);
  }

  private void offer(double t, int code, int contact) {
    if (t <= latest) {
      settle();
    }
    take(t, code, contact);
  }

  // Moving obstacles.

  @Override
  void considerMotion(int i, double end) {
    int code = obstacles.motions().code(i);
    if (obstacles.motions().turns(i)) {
      considerTurn(i, code, Math.min(end, latest));
    } else if (!ignores(code)) {
      fly();
      chooseMoving(i);
      ask(code, Math.min(end, latest));
    }
  }

  /** The same for one that turns: even a straight flight can return to it. */
  private void considerTurn(int i, int code, double end) {
    if (letsThrough(code) || isOutOfReach(i, code, end)) {
      return;
    }
    fly();
    chooseMoving(i);
    double t = time(code, NEVER, asked(end));
    if (t <= end) {
      offer(t, code, contact(code, t));
    }
  }

  /** Whether the path certainly stays outside of the disk about the pivot in which it turns. */
  private boolean isOutOfReach(int i, int code, double end) {
    ObstacleRows rows = obstacles.of(code);
    double[] v = rows.values;
    int a = rows.offset(code);
    int b = a + rows.shape.toEnd;
    double pivotX = obstacles.motions().pivotX(i);
    double pivotY = obstacles.motions().pivotY(i);
    double startX = v[a + ObstacleShape.X] - pivotX;
    double startY = v[a + ObstacleShape.Y] - pivotY;
    double endX = v[b + ObstacleShape.X] - pivotX;
    double endY = v[b + ObstacleShape.Y] - pivotY;
    double square = Math.max(startX * startX + startY * startY, endX * endX + endY * endY);
    double x = px - pivotX;
    double y = py - pivotY;
    double nearest = -(x * vx + y * vy) / (vx * vx + vy * vy);
    double t = nearest > 0 ? Math.min(nearest, end) : 0; // 0 at rest
    double nearX = fma(vx, t, x);
    double nearY = fma(vy, t, y);
    double size = Math.abs(px) + Math.abs(py) + Math.abs(pivotX) + Math.abs(pivotY);
    double way = (Math.abs(vx) + Math.abs(vy)) * t;
    double reach = Math.sqrt(square) + rows.shape.radius(v, a) + r + ROUNDING * (size + way);
    return nearX * nearX + nearY * nearY > (1 + ROUNDING) * (reach * reach);
  }

  // Exact times.

  @Override
  RealRoot exactTime(int code, int contact, double t) {
    if (Codes.isWall(code)) {
      boolean vertical = Codes.isVertical(code);
      return WallSweep.exactTime(vertical ? px : py, r, vertical ? vx : vy, obstacles.walls[code]);
    }
    fly();
    chooseAny(code);
    return fall.turns() ? FallSweep.exact(fall).at(t) : FallSweep.exactTime(fall, contact);
  }
}
