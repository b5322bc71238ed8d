// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Outcome;
import dev.carom.Timeline;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Circles that ignore each other: none makes endless rows at one place. One that is trapped jams
 * after few of them, and once it rests it makes no more until an edit. With gravity nothing is
 * demanded: a ball may bounce at one place as often as it likes.
 */
final class JamCheck {

  /** Rows at one place until a circle is jammed: 1,536 elastic impacts, and some that jam it. */
  static final int MOST = 1_600;

  /** The part of its coordinates by which a circle at one place moves at most from row to row. */
  private static final double PLACE = 0x1p-41;

  /** In a pocket rounding of so much of a speed may be left, which leads to some more rows. */
  private static final double FAINT = 0x1p-40;

  private static final class Run {
    double x = Double.NaN;
    double y;
    int rows;

    /** When the circle was jammed last. */
    double jammed = Double.NaN;
  }

  private final Set<Integer> trapped;
  private final double faint;
  private final Map<Integer, Run> runs = new HashMap<>();

  /** Trapped circles that a whole step has brought to rest since the last edit. */
  private final Set<Integer> jammed = new HashSet<>();

  JamCheck(Set<Integer> trapped, double speedUnit) {
    this.trapped = trapped;
    faint = FAINT * speedUnit;
  }

  /** Notes that something was edited. */
  void edited() {
    runs.clear();
    jammed.clear();
  }

  /** Looks at a step, which led to its end or not. */
  void check(World world, Timeline timeline, boolean complete) throws FindingException {
    if (world.scene().collide() || !world.gravity().equals(Vec2.ZERO)) {
      return;
    }
    ImpactLog log = world.impacts();
    for (int row = 0; row < log.size(); row++) {
      if (log.outcome(row) != Outcome.SENSED) {
        int i = log.circle(row);
        if (jammed.contains(i) && log.approachSpeed(row) > faint) {
          throw new FindingException("circle %d was jammed, and makes another row".formatted(i));
        }
        double t = log.time(row);
        Run run = runs.computeIfAbsent(i, k -> new Run());
        count(run, i, t, timeline.x(i, t), timeline.y(i, t), world.radius(i));
        if (log.outcome(row) == Outcome.JAMMED) {
          run.jammed = t;
        }
      }
    }
    if (complete) {
      for (int i : trapped) {
        if (world.contains(Kind.CIRCLE, i) && rests(world, i)) {
          jammed.add(i);
        }
      }
    }
  }

  /** Whether a circle is left no motion but rounding; a short step may end before that. */
  private boolean rests(World world, int i) {
    return Math.hypot(world.vx(i), world.vy(i)) <= faint;
  }

  /** Counts the rows at one place. A jammed circle makes another row only if something frees it. */
  private void count(Run run, int i, double t, double x, double y, double r)
      throws FindingException {
    double size = Math.max(r, Math.max(Math.abs(x), Math.abs(y)));
    boolean moved = !(Math.hypot(x - run.x, y - run.y) <= PLACE * size);
    boolean begins = moved || t > run.jammed;
    run.rows = begins && !trapped.contains(i) ? 1 : run.rows + 1;
    run.x = x;
    run.y = y;
    if (run.rows > MOST) {
      throw new FindingException("circle %d made %d rows at one place".formatted(i, run.rows));
    }
  }
}
