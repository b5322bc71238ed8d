// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.response.ContactCluster;
import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.response.PairResponse;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.DueTimes;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.UndoLog;

/**
 * The engine for circles that ignore each other. Each circle is advanced to the end of a step on
 * its own, without a queue. A circle without an event in the step costs one comparison.
 */
public final class IndependentEngine extends Engine {

  /** Circles that a step may advance before the undo log grows. */
  private static final int JOURNAL = 1024;

  /**
   * The budget of impacts of all circles together in one call, as the documentation of World states
   * it.
   */
  private static final int IMPACTS_PER_CALL = 2_000_000;

  /** The budget of impacts that each circle has in a call, however many the others made. */
  private static final int IMPACTS_PER_CIRCLE = 1_000;

  private final long impactsPerCall;
  private final long impactsPerCircle;

  private final UndoLog undoLog;
  private final DuePrefetcher prefetcher;

  /** Null until it is needed. */
  private ContactCluster cluster;

  /** Impacts made in this pass, and exact work in units of impacts. */
  private long spent;

  public IndependentEngine(
      SceneData scene, CircleRegistry registry, EngineOptions options, ImpactRows log) {
    super(scene, registry, new CircleTable(scene.circleCount()), options, log);
    impactsPerCall = (long) (IMPACTS_PER_CALL * options.budget());
    impactsPerCircle = (long) (IMPACTS_PER_CIRCLE * options.budget());
    int count = circles.count;
    prefetcher = new DuePrefetcher(circles, staticScene);
    undoLog = new UndoLog(Math.min(count, JOURNAL));
    for (int i = 0; i < count; i++) {
      circles.start(scene, i);
      release(circles.body);
      staticScene.extend(circles.body, 0);
      circles.storeAndSetDue(i);
    }
  }

  @Override
  public String engineDescription() {
    return staticScene.model(false).toString();
  }

  /**
   * Advances all circles to the given time. If a circle exhausts the budget earlier, all are
   * advanced to the time of its last impact instead.
   *
   * @return the time reached
   */
  @Override
  public double advance(double end) {
    prepare(end);
    undoLog.clear();
    unfinished = false;
    reached = end;
    double goal;
    do {
      goal = reached;
      reached = pass(goal);
      if (reached < goal) {
        undoLog.restore(circles);
        log.clear();
        if (recorder != null) {
          recorder.undo();
        }
      }
    } while (reached < goal);
    return reached;
  }

  @Override
  public double advanceToImpact(double end) {
    prepare(end);
    return advance(Math.min(end, nextImpact(end)));
  }

  /**
   * The first double that is not before the next impact; infinite if no impact comes until the
   * given time.
   */
  private double nextImpact(double end) {
    DueTimes due = circles.due;
    MovingCircle m = circles.body;
    while (true) {
      int i = due.earliest(end);
      if (i == due.size()) {
        return Double.POSITIVE_INFINITY;
      }
      circles.load(i);
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
    spent = 0;
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
    long allowance = Math.max(impactsPerCircle, impactsPerCall - spent);
    long before = work.bits();
    int impacts = 0;
    double reached = 0;
    double due = m.due();
    do {
      if (m.next != MovingCircle.NOTHING) {
        if (impacts > 0 && impacts + work.impactsSince(before) >= allowance) {
          spent += allowance;
          return reached;
        }
        reached = due; // a sensor begins no new flight
        int result = response.resolve(m, log);
        if (result == ObstacleResponse.STUCK && staticScene.obstacles.areMoving()) {
          cluster().resolve(log, m);
        }
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

  /** Resolves what a moving obstacle squeezes. */
  private ContactCluster cluster() {
    if (cluster == null) {
      PairResponse pairs = new PairResponse(registry, response.settling);
      ObstacleTable obstacles = staticScene.obstacles;
      cluster = new ContactCluster(registry, pairs, response, obstacles, new Solitude());
    }
    return cluster;
  }

  /** No circle is near another one: they ignore each other. */
  private final class Solitude implements ContactCluster.Vicinity {

    @Override
    public int[] circlesNear(int i) {
      return new int[0];
    }

    @Override
    public MovingCircle copyOf(int i) {
      throw new AssertionError("circle " + i + " ignores all others");
    }

    @Override
    public int[] obstaclesNear(MovingCircle m) {
      return staticScene.near(m);
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
