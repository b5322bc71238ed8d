// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.queue.CalendarQueue;
import dev.carom.internal.response.PairResponse;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.MovingCircle;

/**
 * What happens next among circles that collide. Each has one event in a queue, the first of three:
 * it meets something that stands still (or the end of what is known of that), it meets another
 * circle, or it leaves a cell.
 *
 * <p>Simultaneous events are taken by kind (wall, line, peg, pair), then by the numbers of what
 * meets.
 */
final class EventScheduler {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** The circles by the times of their events. */
  final CalendarQueue queue;

  private final double[] state;
  private final int[] codes;
  private final NeighborGrid neighbors;
  private final CollisionPredictor predictor;
  private final PairResponse pairs;

  EventScheduler(
      CircleTable circles,
      CircleRegistry registry,
      NeighborGrid neighbors,
      CollisionPredictor predictor,
      PairResponse pairs,
      int room) {
    state = circles.state;
    codes = circles.codes;
    this.neighbors = neighbors;
    this.predictor = predictor;
    this.pairs = pairs;
    boolean many = room >= EventPrefetcher.LEAST_CIRCLES;
    EventPrefetcher prefetcher = many ? new EventPrefetcher(circles, registry, neighbors) : null;
    queue = new CalendarQueue(room, this::before, prefetcher, circles.codes);
  }

  /** The kind of a circle's event. */
  static int kind(int[] c, int i) {
    return c[CircleTable.collidingCodesAt(i) + CircleTable.KIND];
  }

  /** Whether the event of circle j is its meeting with circle i, as both are now. */
  static boolean isSame(int[] c, int i, int j) {
    return kind(c, j) == EventKind.PAIR
        && CollisionPredictor.partner(c, j) == i
        && CollisionPredictor.isValid(c, j);
  }

  /** Lets a circle be looked at anew at the given time. */
  void edit(int i, double time) {
    put(i, time, EventKind.EDIT);
  }

  private void put(int i, double time, int kind) {
    codes[CircleTable.collidingCodesAt(i) + CircleTable.KIND] = kind;
    queue.set(i, time);
  }

  /** Whether it is known what a circle meets that stands still, or that there is nothing near. */
  static boolean isLookedAhead(double[] s, int[] c, int i) {
    return cleared(s, i) > 0 || next(c, i) >= 0;
  }

  private static double cleared(double[] s, int i) {
    return s[CircleTable.collidingAt(i) + CircleTable.CLEARED];
  }

  /** What is ahead of a circle; negative for nothing. */
  private static int next(int[] c, int i) {
    return c[CircleTable.collidingCodesAt(i) + CircleTable.NEXT];
  }

  /** When the obstacle ahead is met, or what is known of obstacles ends. */
  private static double due(double[] s, int[] c, int i) {
    int a = CircleTable.collidingAt(i);
    double cleared = s[a + CircleTable.CLEARED];
    return isLookedAhead(s, c, i) && cleared < NEVER
        ? MovingCircle.sum(s[a + FlightRow.T], s[a + FlightRow.TL], cleared)
        : NEVER;
  }

  /** The tail of the time of the obstacle ahead. */
  private double dueTail(int i) {
    int a = CircleTable.collidingAt(i);
    double t = state[a + FlightRow.T];
    double tl = state[a + FlightRow.TL];
    double cleared = state[a + CircleTable.CLEARED];
    return next(codes, i) < 0
        ? Double.NEGATIVE_INFINITY
        : MovingCircle.sumTail(t, tl, cleared, MovingCircle.sum(t, tl, cleared));
  }

  /** Puts the first of a circle's events into the queue. */
  void set(int i) {
    double crossing = neighbors.crossing(state, i);
    set(state, codes, i, crossing, neighbors.way());
  }

  /** The same with the crossing that is next, {@code way} over which edge. */
  void set(double[] s, int[] c, int i, double crossing, int way) {
    double due = due(s, c, i);
    // What is refined only when its turn comes is then still before the crossing and the obstacle.
    if (CollisionPredictor.isInDoubt(s, c, i, due < crossing ? due : crossing)) {
      predictor.refine(s, c, i);
    }
    double meeting = CollisionPredictor.time(s, i);
    double time = Math.min(crossing, meeting);
    // Without a branch, as it cannot be foretold: if none ever is, there is no event of any kind.
    int pair = (int) (Double.doubleToRawLongBits(meeting - crossing) >> 63);
    int cross = EventKind.CROSSING + way;
    int kind = cross ^ ((cross ^ EventKind.PAIR) & pair);
    // Within one stored time a fast circle could go on through the cells behind what it hits.
    if (meeting == crossing && meeting < NEVER && isBeforeCrossing(i)) {
      kind = EventKind.PAIR;
    }
    if (due <= time
        && (due < crossing || cleared(s, i) < neighbors.until(s, i))
        && !(meeting <= due && isBeforeObstacle(i))) {
      kind = EventKind.STATIC;
      time = due;
    }
    c[CircleTable.collidingCodesAt(i) + CircleTable.KIND] = kind;
    queue.set(i, time);
  }

  /** Of a meeting and a crossing at one time: if the meeting is first, or is to be refined. */
  private boolean isBeforeCrossing(int i) {
    return CollisionPredictor.tail(state, i) < crossingTail(i);
  }

  /** Of a meeting and an obstacle at one time: if the meeting is first, or is to be refined. */
  private boolean isBeforeObstacle(int i) {
    double tail = CollisionPredictor.tail(state, i);
    double other = dueTail(i);
    return tail < other
        || (tail == other && pairs.isSilent(i, CollisionPredictor.partner(codes, i)));
  }

  /** The order of two events of the same time. */
  private boolean before(int i, int j) {
    double a = tail(i);
    double b = tail(j);
    return a != b ? a < b : rank(i) < rank(j);
  }

  private double tail(int i) {
    return switch (kind(codes, i)) {
      case EventKind.STATIC -> dueTail(i);
      case EventKind.PAIR -> CollisionPredictor.tail(state, i);
      case EventKind.EDIT -> Double.NEGATIVE_INFINITY;
      default -> crossingTail(i);
    };
  }

  private double crossingTail(int i) {
    double until = neighbors.until(state, i);
    int a = CircleTable.collidingAt(i);
    double t = state[a + FlightRow.T];
    double tl = state[a + FlightRow.TL];
    return MovingCircle.sumTail(t, tl, until, MovingCircle.sum(t, tl, until));
  }

  private long rank(int i) {
    return switch (kind(codes, i)) {
      case EventKind.STATIC -> next(codes, i) < 0 ? i : (long) next(codes, i) << 31 | i;
      case EventKind.PAIR -> {
        int j = CollisionPredictor.partner(codes, i);
        yield pairs.rank(Math.min(i, j), Math.max(i, j));
      }
      default -> i;
    };
  }
}
