// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.response.LoneContact;
import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.response.Shock;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.DueTimes;
import dev.carom.internal.state.EngineDescription;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.FlightTable;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.UndoLog;

/**
 * The engine for circles that ignore each other. Each circle is advanced to the end of a step on
 * its own, without a queue. A circle without an event in the step costs one comparison.
 */
public final class IndependentEngine extends Engine {

  /** Circles that a step may advance before the undo log grows. */
  private static final int JOURNAL = 1024;

  private final UndoLog undoLog;
  private final DuePrefetcher prefetcher;

  private final Shock shock;
  private final LoneContact contact;

  /** The work that each circle may do in this call, however much the others did. */
  private long ownWork;

  /** When this much is {@link #spent}, no circle may do more in this pass than its own work. */
  private long commonLimit;

  /** The circle that comes next, or exhausted the budget. */
  private int spender;

  public IndependentEngine(
      SceneData scene, CircleRegistry registry, EngineOptions options, ImpactRows log) {
    super(scene, registry, new CircleTable(scene.circleCount()), options, log);
    int count = circles.count;
    prefetcher = new DuePrefetcher(circles, staticScene);
    undoLog = new UndoLog(Math.min(count, JOURNAL));
    contact = new LoneContact(staticScene.obstacles, registry, gravity, staticScene::addNear);
    shock = new Shock(registry, staticScene.obstacles, staticScene::addNear, null);
    response.ask(shock);
    for (int i = 0; i < count; i++) {
      circles.start(scene, i);
      release(circles.body);
      staticScene.extend(circles.body, 0);
      circles.storeAndSetDue(i);
    }
  }

  @Override
  public EngineDescription description() {
    return staticScene.model(false);
  }

  /**
   * Advances all circles to the given time. If a circle exhausts the budget earlier, all are
   * advanced to the time of its last impact instead. Each circle makes at least one impact.
   */
  @Override
  double play(double end, long work) {
    prepare(end);
    int rows = log.size();
    ownWork = Math.max(1, work / (WORK_PER_CALL / WORK_PER_CIRCLE + registry.count()));
    long commonWork = work - ownWork * registry.count();
    undoLog.clear();
    unfinished = false;
    reached = end;
    double goal;
    do {
      goal = reached;
      commonLimit = spent + commonWork;
      reached = pass(goal);
      if (reached < goal) {
        undoLog.restore(circles);
        log.cut(rows);
        if (recorder != null) {
          recorder.undo();
        }
      }
    } while (reached < goal);
    return reached;
  }

  @Override
  double playToImpact(double end, long work) {
    prepare(end);
    return play(Math.min(end, nextEvent(end)), work);
  }

  @Override
  public int spender() {
    return spender;
  }

  /**
   * The first double that is not before the next impact or tick; infinite if none comes until the
   * given time.
   */
  private double nextEvent(double end) {
    DueTimes due = circles.due;
    MovingCircle m = circles.body;
    while (true) {
      int i = due.earliest(end);
      if (i == due.size()) {
        return Double.POSITIVE_INFINITY;
      }
      spender = i;
      circles.load(i);
      if (m.ticksNext()) {
        return m.due();
      }
      if (m.next != MovingCircle.NOTHING) {
        double head = m.due();
        return MovingCircle.firstNotBefore(head, m.afterTail(m.cleared, head));
      }
      staticScene.extend(m, m.cleared);
      circles.storeAndSetDue(i);
    }
  }

  /**
   * Advances all circles to the given time, or to the earliest time at which one exhausts its
   * budget.
   */
  private double pass(double goal) {
    ExactBudget work = ExactBudget.ofThread();
    DueTimes due = circles.due;
    double end = goal;
    boolean many = circles.count >= DuePrefetcher.LEAST_CIRCLES;
    int i = many ? prefetcher.first(end) : due.next(0, end);
    while (i < due.size()) {
      circles.load(i);
      undoLog.save(circles.body);
      double stopped = resolveUntil(circles.body, work, end);
      circles.storeAndSetDue(i);
      if (stopped <= end) {
        unfinished = true;
        spender = i;
        end = stopped;
      }
      i = many ? prefetcher.next(end) : due.next(i + 1, end);
    }
    return end;
  }

  /**
   * Resolves a circle's impacts until the given time.
   *
   * @return the time of the last one if the budget is exhausted, else {@code +infinity}
   */
  private double resolveUntil(MovingCircle m, ExactBudget work, double end) {
    long allowance = Math.max(ownWork, commonLimit - spent);
    long before = work.bits();
    int impacts = 0;
    double reached = 0;
    double due = m.due();
    do {
      boolean ticks = m.ticksNext();
      if (ticks || m.next != MovingCircle.NOTHING) {
        if (impacts > 0 && impacts + work.impactsSince(before) >= allowance) {
          spent += allowance;
          return reached;
        }
        reached = due; // a sensor begins no new flight
        int result = ticks ? tick(m) : resolve(m);
        if (result != ObstacleResponse.SENSED && recorder != null) {
          recorder.note(m);
        }
        impacts++;
      }
      staticScene.extend(m, end - m.t);
      due = m.due();
    } while (due <= end);
    spent += impacts + work.impactsSince(before);
    return Double.POSITIVE_INFINITY;
  }

  private int tick(MovingCircle m) {
    contact.tick(m, log);
    return ObstacleResponse.NEW_FLIGHT;
  }

  private int resolve(MovingCircle m) {
    if (m.isMember() && !staticScene.obstacles.isSensor(m.next)) {
      contact.meet(m, log);
      return ObstacleResponse.NEW_FLIGHT;
    }
    int result = response.resolve(m, log);
    if (result == ObstacleResponse.STUCK) {
      shock.resolve(log, m);
    } else if (result == ObstacleResponse.JOIN) {
      contact.join(m, log);
    }
    return result;
  }

  @Override
  void leaveContact(MovingCircle m, double now) {
    if (m.isMember()) {
      contact.leave(m, now);
      circles.storeAndSetDue(m.id, m);
    }
  }

  /** Members near a thing that changes begin anew. */
  @Override
  void noteContact(int code, double now) {
    if (!circles.allowsGravity() || Codes.isCircle(code)) {
      return;
    }
    contact.changed();
    MovingCircle m = circles.body;
    LiveCodes present = registry.present();
    for (int k = 0; k < present.size(); k++) {
      int i = present.get(k);
      if (registry.contains(i) && circles.isMember(i)) {
        circles.load(i);
        if (contact.isNear(m, code, now)) {
          contact.leave(m, now);
          m.newFlight();
          release(m);
          beginFlight(m);
        }
      }
    }
  }

  @Override
  void beginFlight(MovingCircle m) {
    if (m.id == circles.count) {
      circles.add();
    }
    staticScene.setRadius(m.id, m.radius);
    circles.storeAndSetDue(m.id, m);
    if (recorder != null) {
      recorder.add(m, m.t);
    }
  }

  @Override
  public void restore(FlightTable flights, double now, double tailOfEdit) {
    contact.changed();
    super.restore(flights, now, tailOfEdit);
  }

  /** Circles ignore each other, so only the circle's own events must precede an edit. */
  @Override
  double tailOfEdit(MovingCircle m, double now) {
    return m.t == now ? Math.max(0, m.tl) : 0;
  }

  @Override
  public double lastTail(double now) {
    return 0;
  }

  @Override
  void remove(int i) {
    circles.due.set(i, Double.POSITIVE_INFINITY);
  }

  @Override
  void store(int i, MovingCircle m) {
    circles.storeAndSetDue(i, m);
  }
}
