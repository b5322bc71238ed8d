// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;

/** Asks {@link FallTimes} about one flight and one obstacle at a time, without any search. */
public final class FallQuestions {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private final ObstacleTable obstacles;
  private final FallSearch falls;

  public FallQuestions(ObstacleTable obstacles) {
    this.obstacles = obstacles;
    falls = new FallSearch(obstacles, new CodeSet());
  }

  private boolean standsStill(MovingCircle m) {
    return m.vx == 0 && m.vy == 0 && m.gx == 0 && m.gy == 0 && !obstacles.areMoving();
  }

  /**
   * The time of the next contact; {@code +infinity} for never.
   *
   * @param sensed when it was last reported, if it is a sensor; 0 for never
   */
  public double time(MovingCircle m, int code, double sensed) {
    boolean finite = Math.abs(m.x) <= Double.MAX_VALUE && Math.abs(m.y) <= Double.MAX_VALUE;
    if (code == m.support || !finite || standsStill(m)) {
      return NEVER;
    }
    falls.start(m);
    if (Codes.isWall(code)) {
      return obstacles.walls == null ? NEVER : falls.wallTime(code, NEVER);
    }
    falls.sensed = sensed;
    falls.sensedCode = code;
    falls.chooseAny(code);
    return falls.time(code, NEVER, end(m, code));
  }

  /** A time after which no contact counts: for ever, what turns is far dearer to ask about. */
  private double end(MovingCircle m, int code) {
    double arrival = obstacles.arrival(code) - m.t - m.tl;
    return obstacles.turns(code) ? FallTimes.asked(Math.max(0, arrival)) : NEVER;
  }

  /** The part of the obstacle that is touched at the time of its contact. */
  public int contact(MovingCircle m, int code, double t) {
    falls.start(m);
    return falls.contact(code, t);
  }

  /** When a circle that slides along a line comes to one of its ends. */
  public double endOfSlide(MovingCircle m) {
    falls.start(m);
    return standsStill(m) ? NEVER : falls.endOfSlide();
  }
}
