// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.reference.Reference;

/** Plays a cell by a method and tells what became of it. */
final class CellJudge {

  /** In radii. */
  static final double RIGHT = 0.001;

  /** In radii. */
  static final double DRIFTED = 1;

  /** As a part of the speed at the start, that of the fastest circle. */
  static final double LOST = 0.01;

  private CellJudge() {}

  /**
   * The judgement of a run.
   *
   * @param outcome its class
   * @param worst how far a circle was from its true place at the end of a frame, at most, in radii;
   *     infinite if the run has no end or the speed at its end is wrong
   */
  record Judged(CellOutcome outcome, double worst) {

    private static Judged lost(CellOutcome outcome) {
      return new Judged(outcome, Double.POSITIVE_INFINITY);
    }

    /** Whether it was never farther away than so many radii. */
    boolean isWithin(double radii) {
      return worst <= radii;
    }
  }

  static Judged of(Contender contender, Cell cell) {
    if (cell.truth() == null) {
      return Judged.lost(CellOutcome.NO_ANSWER);
    }
    try (Method method = contender.start(cell.scene())) {
      return play(method, cell);
    } catch (UnsupportedOperationException | IllegalArgumentException | IllegalStateException e) {
      return Judged.lost(CellOutcome.NO_ANSWER);
    }
  }

  private static Judged play(Method method, Cell cell) {
    Reference truth = cell.truth();
    double worst = 0;
    for (int frame = 1; frame <= truth.frames(); frame++) {
      method.frame();
      for (int i = 0; i < truth.circles(); i++) {
        double x = method.x(i);
        double y = method.y(i);
        if (!Double.isFinite(x) || !Double.isFinite(y) || cell.fence().isBeyond(x, y)) {
          return Judged.lost(CellOutcome.ESCAPED);
        }
        double error = Math.hypot(x - truth.x(frame, i), y - truth.y(frame, i));
        worst = Math.max(worst, error / ((Circle) cell.scene().shape(Kind.CIRCLE, i)).radius());
      }
    }
    if (speedError(method, truth) > LOST * SceneDrawing.fastest(cell.scene())) {
      return Judged.lost(CellOutcome.LOST_SPEED);
    }
    CellOutcome outcome =
        worst <= RIGHT
            ? CellOutcome.RIGHT
            : worst <= DRIFTED ? CellOutcome.DRIFTED : CellOutcome.FAR_OFF;
    return new Judged(outcome, worst);
  }

  private static double speedError(Method method, Reference truth) {
    int end = truth.frames();
    double worst = 0;
    for (int i = 0; i < truth.circles(); i++) {
      double speed = Math.hypot(method.vx(i), method.vy(i));
      double error = Math.abs(speed - Math.hypot(truth.vx(end, i), truth.vy(end, i)));
      worst = Double.isFinite(error) ? Math.max(worst, error) : Double.POSITIVE_INFINITY;
    }
    return worst;
  }
}
