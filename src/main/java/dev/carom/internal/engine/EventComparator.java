// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.queue.EventOrder;
import dev.carom.internal.response.PairResponse;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.MovingCircle;

/**
 * The order of events with equal rounded times: by the tails of their times, then by kind (wall,
 * line, peg, pair), then by the codes of what collides.
 */
final class EventComparator implements EventOrder {

  private static final double FIRST = Double.NEGATIVE_INFINITY;

  private final double[] state;
  private final int[] codes;
  private final PairResponse pairs;

  EventComparator(CircleTable circles, PairResponse pairs) {
    state = circles.state;
    codes = circles.codes;
    this.pairs = pairs;
  }

  @Override
  public boolean before(int i, int j) {
    double a = tail(i);
    double b = tail(j);
    return a != b ? a < b : rank(i) < rank(j);
  }

  private double tail(int i) {
    return switch (EventScheduler.kind(codes, i)) {
      case EventKind.STATIC -> obstacleTail(i);
      case EventKind.PAIR -> CollisionPredictor.tail(state, i);
      case EventKind.EDIT -> FIRST;
      default -> crossingTail(i);
    };
  }

  private long rank(int i) {
    return switch (EventScheduler.kind(codes, i)) {
      case EventKind.STATIC -> {
        int next = EventScheduler.next(codes, i);
        yield next < 0 ? i : Codes.rank(next, i);
      }
      case EventKind.PAIR -> {
        int j = CollisionPredictor.partner(codes, i);
        yield pairs.rank(Math.min(i, j), Math.max(i, j));
      }
      default -> i;
    };
  }

  /**
   * Whether a circle's collision comes before its cell crossing at the same rounded time. True for
   * a collision that is still to be refined.
   */
  boolean isMeetingBeforeCrossing(int i) {
    return CollisionPredictor.tail(state, i) < crossingTail(i);
  }

  /**
   * Whether a circle's collision comes before its impact with an obstacle at the same rounded time.
   * True for a collision that is still to be refined.
   */
  boolean isMeetingBeforeObstacle(int i) {
    double meeting = CollisionPredictor.tail(state, i);
    double obstacle = obstacleTail(i);
    return meeting < obstacle
        || (meeting == obstacle && pairs.isSilent(i, CollisionPredictor.partner(codes, i)));
  }

  /** The tail of the time of the next impact with an obstacle. */
  private double obstacleTail(int i) {
    return EventScheduler.next(codes, i) < 0
        ? FIRST
        : tailAfter(i, EventScheduler.cleared(state, i));
  }

  private double crossingTail(int i) {
    return tailAfter(i, NeighborGrid.untilCrossing(state, i));
  }

  /** The tail of the time at a given duration after the start of a circle's flight. */
  private double tailAfter(int i, double after) {
    int a = CircleTable.collidingAt(i);
    double t = state[a + FlightRow.T];
    double tl = state[a + FlightRow.TL];
    return MovingCircle.sumTail(t, tl, after, MovingCircle.sum(t, tl, after));
  }
}
