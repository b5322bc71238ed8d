// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.queue.CalendarQueue;
import dev.carom.internal.response.PairResponse;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;

/**
 * Schedules the next event of each circle that collides. It owns the cells of the circles, the
 * predictor of collisions, and the event queue. It asks the static scene for obstacles. Each circle
 * has one event in the queue, the earliest of three: it hits an obstacle (or its prediction of
 * obstacles ends), it collides with another circle, or it leaves a cell.
 *
 * <p>The three parts depend on each other and on the capacity of the circle table. So they are
 * created together, and replaced together when an edit needs more room or other cells.
 */
final class EventScheduler {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private final CircleTable circles;
  private final StaticScene staticScene;
  private final CalendarQueue queue;
  private final NeighborGrid neighbors;
  private final CollisionPredictor predictor;
  private final EventComparator order;
  private final double[] state;
  private final int[] codes;

  // The neighbours found of one circle, and of another.
  private final int[] found;
  private final int[] foundOfOther;

  /** Whether circles may have accelerations. */
  private final boolean falls;

  /** Whether this step has no lines and no pegs. */
  private boolean nothingInside;

  /**
   * Creates a scheduler without events.
   *
   * @param diameters the width of a cell in largest diameters
   */
  EventScheduler(
      CircleTable circles,
      CircleRegistry registry,
      StaticScene staticScene,
      PairResponse pairs,
      Contacts contacts,
      double diameters,
      double now) {
    this.circles = circles;
    this.staticScene = staticScene;
    state = circles.state;
    codes = circles.codes;
    falls = circles.allowsGravity();
    int room = circles.capacity();
    found = new int[room + NeighborGrid.SPARE];
    foundOfOther = new int[room + NeighborGrid.SPARE];
    double[] walls = staticScene.obstacles.walls;
    neighbors = new NeighborGrid(circles, registry.slots(), walls, diameters, now);
    predictor = new CollisionPredictor(circles, pairs, contacts);
    order = new EventComparator(circles, pairs);
    boolean many = room >= EventPrefetcher.LEAST_CIRCLES;
    EventPrefetcher prefetcher = many ? new EventPrefetcher(circles, registry, neighbors) : null;
    queue = new CalendarQueue(room, order, prefetcher, codes);
    beginStep();
  }

  /** Must be called before a step, as edits may have added or removed obstacles. */
  void beginStep() {
    nothingInside = staticScene.obstacles.size() == 0;
  }

  /** The kind of a circle's event. */
  static int kind(int[] c, int i) {
    return c[CircleTable.collidingCodesAt(i) + CircleTable.KIND];
  }

  /** Whether the event of circle j is its collision with circle i, and not stale. */
  static boolean isSame(int[] c, int i, int j) {
    return kind(c, j) == EventKind.PAIR
        && CollisionPredictor.partner(c, j) == i
        && CollisionPredictor.isValid(c, j);
  }

  /** Whether a circle's next obstacle is predicted, or the absence of near ones. */
  static boolean isObstacleKnown(double[] s, int[] c, int i) {
    return cleared(s, i) > 0 || next(c, i) >= 0;
  }

  static double cleared(double[] s, int i) {
    return s[CircleTable.collidingAt(i) + CircleTable.CLEARED];
  }

  /** The code of a circle's next obstacle; negative for none. */
  static int next(int[] c, int i) {
    return c[CircleTable.collidingCodesAt(i) + CircleTable.NEXT];
  }

  // The queue.

  /**
   * Removes the first event if it is due by a given time; {@link #polledTime} is its time.
   *
   * @return its circle, or {@link Index#NONE}
   */
  int poll(double end) {
    return queue.poll(end);
  }

  double polledTime() {
    return queue.polledTime();
  }

  /** The circle whose event is first, or {@link Index#NONE}. */
  int first() {
    return queue.first();
  }

  /** The time of the first event; infinite if there is none. */
  double firstTime() {
    int i = queue.first();
    return i == Index.NONE ? NEVER : queue.time(i);
  }

  /**
   * Removes the event of a circle. Must be called before anything changes that orders the event.
   */
  void cancel(int i) {
    queue.clear(i);
  }

  /**
   * Computes the exact time of the collision predicted of circle i, whose event was just polled.
   *
   * @return whether the collision comes by a given time and before all other events; if not, it is
   *     rescheduled, and so is the event of its partner j if that is the same collision
   */
  boolean confirm(double[] s, int[] c, int i, int j, double end) {
    predictor.refine(s, c, i);
    boolean isOfBoth = isSame(c, i, j);
    if (isOfBoth) {
      queue.clear(j); // otherwise the same event would seem to be earlier
    }
    double time = CollisionPredictor.time(s, i);
    if (time <= end && queue.isBeforeAll(time)) {
      return true;
    }
    schedule(i);
    if (isOfBoth) {
      schedule(j);
    }
    return false;
  }

  // Predictions.

  /** Predicts a circle's next collision anew, and schedules its first event. */
  void predict(int i) {
    double[] s = state;
    int[] c = codes;
    int size = neighbors.find(c, i, found);
    double crossing = neighbors.nextCrossing(s, c, i);
    predictor.predictAmong(s, c, i, found, filterPairs(s, c, i, found, size));
    schedule(s, c, i, crossing);
  }

  private int filterPairs(double[] s, int[] c, int i, int[] others, int size) {
    return falls
        ? predictor.filterFalling(s, c, i, others, size)
        : CollisionPredictor.filterPairs(s, c, i, others, size);
  }

  /**
   * The same for two circles: first the branch-free part of both, then the part that branches. So
   * the latencies of both overlap.
   */
  void predict(double[] s, int[] c, int i, int j) {
    int size = neighbors.find(c, i, found);
    int sizeOfJ = neighbors.find(c, j, foundOfOther);
    double crossing = neighbors.nextCrossing(s, c, i);
    double crossingOfJ = neighbors.nextCrossing(s, c, j);
    int leftOfI = filterPairs(s, c, i, found, size);
    int leftOfJ = filterPairs(s, c, j, foundOfOther, sizeOfJ);
    predictor.predictAmong(s, c, i, found, leftOfI);
    schedule(s, c, i, crossing);
    predictor.predictAmong(s, c, j, foundOfOther, leftOfJ);
    schedule(s, c, j, crossingOfJ);
  }

  /** Moves a circle into the cell that it enters, and schedules its next event. */
  void cross(double[] s, int[] c, int i, int way) {
    int size = neighbors.cross(s, c, i, way, found);
    double crossing = neighbors.nextCrossing(s, c, i);
    if (needsObstacle(s, c, i)) { // as findNextObstacle, which compilers inline in some runs only
      searchObstacles(i);
    }
    if (predictor.predictEarlier(s, c, i, found, size)) {
      schedule(s, c, i, crossing);
    } else {
      predict(i);
    }
  }

  /**
   * Predicts a circle's next impact with an obstacle, unless that is known or its cell can hold
   * none.
   */
  void findNextObstacle(double[] s, int[] c, int i) {
    if (needsObstacle(s, c, i)) {
      searchObstacles(i);
    }
  }

  private boolean needsObstacle(double[] s, int[] c, int i) {
    boolean nothingNear = nothingInside && neighbors.isInside(s, i);
    return !nothingNear && !isObstacleKnown(s, c, i);
  }

  private void searchObstacles(int i) {
    circles.load(i);
    staticScene.extend(circles.body, 0);
    circles.put(i, circles.body);
  }

  /** Schedules the first event of a circle whose predictions are complete. */
  void schedule(int i) {
    schedule(state, codes, i, neighbors.nextCrossing(state, codes, i));
  }

  private void schedule(double[] s, int[] c, int i, double crossing) {
    double obstacle = obstacle(s, c, i);
    // A collision that is refined only when it is polled is then certainly before crossing and
    // obstacle.
    if (CollisionPredictor.isInDoubt(s, c, i, obstacle < crossing ? obstacle : crossing)) {
      predictor.refine(s, c, i);
    }
    double meeting = CollisionPredictor.time(s, i);
    double time = Math.min(crossing, meeting);
    // Branch-free, as it is unpredictable. If all times are infinite, the kind does not matter.
    int pair = (int) (Double.doubleToRawLongBits(meeting - crossing) >> 63);
    int cross = EventKind.CROSSING + c[CircleTable.collidingCodesAt(i) + CircleTable.WAY];
    int kind = cross ^ ((cross ^ EventKind.PAIR) & pair);
    // Within one rounded time a fast circle could otherwise go on through the cells behind what it
    // hits.
    if (meeting == crossing && meeting < NEVER && order.isMeetingBeforeCrossing(i)) {
      kind = EventKind.PAIR;
    }
    if (obstacle <= time
        && (obstacle < crossing || cleared(s, i) < NeighborGrid.untilCrossing(s, i))
        && !(meeting <= obstacle && order.isMeetingBeforeObstacle(i))) {
      kind = EventKind.STATIC;
      time = obstacle;
    }
    put(c, i, time, kind);
  }

  /** The time of the next impact with an obstacle, or at which the prediction of obstacles ends. */
  private static double obstacle(double[] s, int[] c, int i) {
    int a = CircleTable.collidingAt(i);
    double cleared = s[a + CircleTable.CLEARED];
    return isObstacleKnown(s, c, i) && cleared < NEVER
        ? MovingCircle.sum(s[a + FlightRow.T], s[a + FlightRow.TL], cleared)
        : NEVER;
  }

  private void put(int[] c, int i, double time, int kind) {
    c[CircleTable.collidingCodesAt(i) + CircleTable.KIND] = kind;
    queue.set(i, time);
  }

  // Cells and edits.

  /** Lists a circle in the cell where its new flight starts, if it is not listed there. */
  void comeBack(double[] s, int i) {
    neighbors.comeBack(s, i);
  }

  /** Adds the circles near a place, see {@link NeighborGrid#addNear}. */
  void addNear(double x, double y, double distance, IntList into) {
    neighbors.addNear(x, y, distance, into);
  }

  /** Schedules the next event of a circle that can meet no other circle. */
  void predictAlone(int i) {
    predictor.predictAmong(state, codes, i, found, 0);
    schedule(i);
  }

  /** Removes a circle from its cells, and its event from the queue. */
  void remove(int i) {
    queue.clear(i);
    neighbors.leave(i);
  }

  /**
   * Lists a circle in the cell of its position at a given time.
   *
   * @return false if its radius is none for which the cells were made
   */
  boolean enter(int i, double now) {
    return neighbors.enter(i, now);
  }

  /** Whether most circles are outside the region of the cells. */
  boolean isRegionLeft(LiveCodes present) {
    return neighbors.isRegionLeft(present);
  }

  /** Schedules a new prediction of a circle at the given time, when all edits are done. */
  void edit(int i, double time) {
    queue.clear(i);
    put(codes, i, time, EventKind.EDIT);
  }
}
