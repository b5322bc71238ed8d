// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.ContactRow;
import dev.carom.internal.state.FlightTable;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SizeLimits;
import dev.carom.internal.state.WorldState;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.Index;

/**
 * Tests whether a world can be in the state that a snapshot gives, one number after the other. A
 * state that it cannot be in is an {@link IllegalArgumentException}.
 */
final class SnapshotChecks {

  private final WorldState state;
  private final double now;
  private final SizeLimits limits;
  private final ObstacleTable obstacles;
  private final CircleRegistry circles;

  SnapshotChecks(WorldState state) {
    this.state = state;
    now = state.now();
    limits = state.limits();
    obstacles = state.obstacles();
    circles = state.registry();
  }

  /** Refuses what is not good with a message that ends with a value. */
  static void expect(boolean good, String otherwise, Object value) {
    if (!good) {
      throw new IllegalArgumentException(otherwise + value);
    }
  }

  /** Refuses ids that are not ascending from 0 on, or not below the limit. */
  static void ids(int[] ids, int limit) {
    int least = 0;
    for (int id : ids) {
      if (id < least || id >= limit) {
        throw Check.refused("circle id", id, least + " to " + (limit - 1) + ", ascending");
      }
      least = id + 1;
    }
  }

  /** Refuses numbers of sides that are not ascending, or not those of lines. */
  static void joined(int[] sides, int lines) {
    int least = 1;
    for (int side : sides) {
      if (side < least || side >= lines) {
        throw Check.refused("joined line", side, least + " to " + (lines - 1) + ", ascending");
      }
      least = side + 1;
    }
  }

  void all() {
    Check.notNegative("now", now);
    Check.finite("gx", state.gx());
    Check.finite("gy", state.gy());
    limits();
    bounds();
    motions(obstacles.motions());
    obstacles.kinds.forEach(this::obstacles);
    double tail = state.tailOfEdit();
    expect(tail >= 0 && tail <= Math.ulp(now), "the tail of the time of an edit is ", tail);
    FlightTable flights = state.flights();
    FlightTable again = new FlightTable(circles.count());
    MovingCircle m = new MovingCircle();
    for (int i = 0; i < circles.count(); i++) {
      traits(circles.traits(i), ContactFlags.MOST);
      Check.mass("mass", circles.mass(i));
      flights.get(i, m);
      motion(m);
      contacts(m);
      m.forgetPrediction(m.cleared, m.sensedCode);
      again.put(i, m);
    }
    expect(flights.equals(again), "the flights are not as they are saved", "");
  }

  private void limits() {
    double largest = limits.largest();
    Check.notNegative("largest coordinate", largest);
    if (!(SizeLimits.leastRadius(largest) <= limits.least())) {
      throw Check.refused(
          "least radius",
          limits.least(),
          "2^10 ulps of the largest coordinate, " + largest + ", or more");
    }
  }

  private void bounds() {
    double[] w = obstacles.walls;
    if (w != null) {
      Check.bounds(w[Codes.LEFT], w[Codes.BOTTOM], w[Codes.RIGHT], w[Codes.TOP]);
    }
    Check.notNegative("restitution", obstacles.boundsRestitution);
    traits(obstacles.boundsTraits, 1);
  }

  private static void traits(int traits, int most) {
    expect(ContactFlags.areKnown(traits, most), "traits are ", traits);
  }

  private void motions(ObstacleMotions motions) {
    int least = Codes.line(0);
    for (int i = 0; i < motions.count(); i++) {
      int code = motions.code(i);
      expectCode(code >= least && isThere(code), code);
      least = code + 1;
      for (int number = 0; number < ObstacleTable.MOST_NUMBERS; number++) {
        Check.finite("the velocity of an obstacle", motions.velocity(i, number));
      }
      double since = motions.since(i);
      expect(since >= 0 && since <= now, "an obstacle moves since ", since);
      double until = motions.until(i);
      expect(until >= now, "an obstacle moves until ", until);
      Check.finite("pivotX of an obstacle", motions.pivotX(i));
      Check.finite("pivotY of an obstacle", motions.pivotY(i));
      double turn = motions.turn(i);
      boolean isTurn = until < Double.POSITIVE_INFINITY && turn <= ObstacleMotions.MOST_TURN;
      expect(turn == 0 || isTurn, "an obstacle turns by ", turn);
    }
  }

  /**
   * Tests the traits of obstacles, and the extent of those at rest; moving ones may be anywhere.
   */
  private void obstacles(ObstacleRows rows) {
    for (int code = rows.first(); code < rows.end; code++) {
      int most = Codes.isLine(code) ? ContactFlags.MOST_OF_LINES : ContactFlags.MOST;
      traits(rows.traits(code), most);
      if (rows.isJoined(code)) {
        joined(rows, code);
      } else if (obstacles.outside(code) != 0) {
        expect(rows.meet(rows.endOf(code) - 1, code), "a polygon is open at line ", rows.id(code));
      }
      double extent = obstacles.isStatic(code) ? obstacles.extent(code) : 0;
      if (extent > limits.largest()) {
        throw Check.refused(
            "coordinate", extent, "at most the stored largest coordinate, " + limits.largest());
      }
    }
  }

  /** Tests that a side of an outline is one with the side before it. */
  private void joined(ObstacleRows rows, int code) {
    int last = code - 1;
    boolean isOne =
        rows.isGone(code) == rows.isGone(last)
            && rows.traits(code) == rows.traits(last)
            && obstacles.filter(code) == obstacles.filter(last)
            && obstacles.moves(code) == obstacles.moves(last)
            && (rows.isGone(code) || rows.meet(last, code));
    expect(isOne, "sides are not joined in line ", rows.id(code));
  }

  private void motion(MovingCircle m) {
    expect(!Double.isNaN(m.x) && !Double.isNaN(m.y), "a number of a circle is ", Double.NaN);
    Check.finite("vx", m.vx);
    Check.finite("vy", m.vy);
    Check.finite("gx", m.gx);
    Check.finite("gy", m.gy);
    expect(m.t >= 0 && m.t <= now, "a flight starts at ", m.t);
    expect(Math.abs(m.tl) <= Math.ulp(m.t), "the tail of a time is ", m.tl);
    Check.finite("radius", m.radius);
    if (Double.compare(m.radius, 0) < 0) { // -0 among them
      throw Check.refused("radius", m.radius, "at least 0");
    }
    if (m.radius == 0 && obstacles.lines.present().count() > 0) {
      throw Check.refused("radius", m.radius, SizeLimits.NO_POINT);
    }
    if (m.radius != 0 && m.radius < limits.least()) {
      throw Check.refused("radius", m.radius, "at least " + limits.least());
    }
    Check.notNegative("restitution", m.restitution);
    expect(m.cleared >= 0, "a flight is known for ", m.cleared);
  }

  private void contacts(MovingCircle m) {
    if (m.last != MovingCircle.NOTHING) {
      expectCode(isKnown(m.last), m.last);
    }
    for (int entry : m.jam == null ? new int[0] : m.jam.entries()) {
      int code = IgnoreList.code(entry);
      boolean mayCrush = Codes.isCircle(code) || obstacles.moves(code);
      expectCode(isKnown(code) && (mayCrush || !IgnoreList.crushes(entry)), code);
    }
    expectCode(m.support == MovingCircle.NOTHING || isThere(m.support), m.support);
    expectCode(m.landing == MovingCircle.NOTHING || isThere(m.landing), m.landing);
    if (m.isMember()) {
      expect(m.contactRow != null, "the state of a circle in contact is ", Double.NaN);
      member(m.contactRow, m.mode != MovingCircle.FROZEN);
    }
    boolean isCount = m.stuck >= 0 && m.stuck <= MovingCircle.STUCK_LIMIT;
    expect(isCount, "the number of impacts at one place is ", m.stuck);
    double sensed = m.sensedHead + m.sensedTail;
    expect(!Double.isNaN(sensed), "a number of a circle is ", sensed);
    expect(m.sensedPartner >= MovingCircle.NOT_SENSED, "a partner is circle ", m.sensedPartner);
    expect(m.sensedCode >= 0, "codes sensed end with ", m.sensedCode);
  }

  /** Tests the {@link ContactRow} of a member, which ticks or is frozen. */
  private void member(double[] row, boolean ticks) {
    boolean fits =
        row.length >= ContactRow.SIZE && (row.length - ContactRow.SIZE) % ContactRow.PAIR == 0;
    expect(fits, "the numbers of a circle in contact are ", row.length);
    for (double number : row) {
      Check.finite("a number of a circle in contact", number);
    }
    double end = row[ContactRow.END];
    boolean isRunning = row[ContactRow.TAU] > 0 && row[ContactRow.DUE] >= end && end >= now;
    expect(isRunning || !ticks, "a tick ends at ", end);
    double margin = row[ContactRow.MARGIN];
    expect(margin >= 0, "the margin of a circle is ", margin);
    expect(row[ContactRow.PULL] >= 0, "the pull on a circle is ", row[ContactRow.PULL]);
    for (int k = ContactRow.SIZE; k < row.length; k += ContactRow.PAIR) {
      double other = row[k + ContactRow.OTHER];
      double key = row[k + ContactRow.KEY];
      boolean isPair =
          other < 0
              ? other == Index.NONE && isWhole(key, 0, 1L << 33) && isKnown((int) ((long) key >> 2))
              : isWhole(other, 0, Integer.MAX_VALUE) && circles.slot((int) other) >= 0;
      expect(isPair, "the other one of a pair is ", other);
      boolean isFlags = isWhole(row[k + ContactRow.FLAGS], 0, 3);
      expect(isFlags && row[k + ContactRow.IMPULSE] >= 0, "an impulse is ", row[k + 2]);
    }
  }

  private static boolean isWhole(double x, double least, double most) {
    return x >= least && x <= most && x == Math.rint(x);
  }

  /** Whether there is a circle of a code, or was an obstacle; walls need not be there. */
  private boolean isKnown(int code) {
    return Codes.isCircle(code)
        ? circles.slot(Codes.slot(code)) >= 0
        : code >= 0 && (Codes.isWall(code) || code < obstacles.of(code).end);
  }

  /** Whether there is an obstacle of a code. */
  private boolean isThere(int code) {
    return !Codes.isCircle(code) && isKnown(code) && obstacles.isThere(code);
  }

  private static void expectCode(boolean exists, int code) {
    if (!exists) {
      throw new IllegalArgumentException("code " + code + " does not exist");
    }
  }
}
