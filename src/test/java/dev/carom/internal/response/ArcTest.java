// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.KindNumber;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The path of a flight as seen from what turns, against that path, point by point. */
class ArcTest {

  private static final double PIVOT_X = 0.5;
  private static final double PIVOT_Y = -0.25;

  private final Random random = new Random(1);
  private final ObstacleTable obstacles = ObstacleTable.empty(null);
  private final Parts parts = new Parts(obstacles, null, null);
  private final Arc arc = new Arc();
  private int part;
  private double now;

  // A flight and its time.
  private double x;
  private double y;
  private double ux;
  private double uy;
  private double h;

  private void turn() {
    int line = obstacles.add(KindNumber.LINE, 0, 0, 3, 0);
    double angle = (random.nextDouble() - 0.5) * Math.PI;
    double[] numbers = {0, 0, 3, 0};
    for (int k = 0; k < 4; k += 2) {
      double c = Math.cos(angle / 2);
      ObstacleMotions.turn(PIVOT_X, PIVOT_Y, c, Math.sin(angle / 2), numbers, k);
    }
    double[] motion = new double[ObstacleMotions.SIZE];
    ObstacleMotions.setTurn(motion, PIVOT_X, PIVOT_Y, angle, 0, 1);
    obstacles.moveTo(line, numbers, motion);
    now = random.nextDouble();
    h = Math.scalb(1.0, -random.nextInt(6)) * (1 - now);
    x = random.nextGaussian();
    y = random.nextGaussian();
    ux = random.nextGaussian();
    uy = random.nextGaussian();
    parts.update();
    Members members = new Members(1);
    members.x[0] = x;
    members.y[0] = y;
    members.radius[0] = 100;
    IntList near = new IntList();
    parts.near(members, 0, new Around(line), 0, now, near);
    part = near.get(0);
    arc.set(parts, part, x, y, h);
  }

  private record Around(int line) implements ContactSurroundings {

    @Override
    public void membersNear(int slot, double x, double y, double reach, IntList into) {
      // It is alone.
    }

    @Override
    public void obstaclesNear(
        int slot, double x, double y, double reach, double now, IntList into) {
      into.add(line);
    }
  }

  /** Where the flight is at a time, in the frame of the line at the start. */
  private double[] seen(double t) {
    double[] from = obstacles.rowAt(parts.codes(part)[0], now, 0);
    double[] to = obstacles.rowAt(parts.codes(part)[0], now + t, 0);
    double by =
        Math.atan2(from[3] - from[1], from[2] - from[0]) - Math.atan2(to[3] - to[1], to[2] - to[0]);
    double dx = x + ux * t - PIVOT_X;
    double dy = y + uy * t - PIVOT_Y;
    return new double[] {
      PIVOT_X + dx * Math.cos(by) - dy * Math.sin(by),
      PIVOT_Y + dx * Math.sin(by) + dy * Math.cos(by)
    };
  }

  @Test
  void itsLastPointIsTheEnd() {
    for (int i = 0; i < 1000; i++) {
      turn();
      double[] end = seen(h);
      assertThat(x + arc.wayX(2, ux, uy)).isCloseTo(end[0], within(1e-14));
      assertThat(y + arc.wayY(2, ux, uy)).isCloseTo(end[1], within(1e-14));
      obstacles.remove(parts.codes(part)[0]);
    }
  }

  /** Along any normal the path is no further than its farthest control point, and hardly less. */
  @Test
  void thePathIsInTheHullOfItsPoints() {
    double slack = 0;
    for (int i = 0; i < 1000; i++) {
      turn();
      double nx = Math.cos(i);
      double ny = Math.sin(i);
      double least = 0;
      for (int k = 0; k < Arc.POINTS; k++) {
        least = Math.min(least, nx * arc.wayX(k, ux, uy) + ny * arc.wayY(k, ux, uy));
      }
      double reached = 0;
      for (double t = 0; t <= h; t += h / 64) {
        double[] there = seen(t);
        reached = Math.min(reached, nx * (there[0] - x) + ny * (there[1] - y));
      }
      assertThat(reached).isGreaterThan(least - 1e-14);
      slack = Math.max(slack, (reached - least) / (h * h));
      obstacles.remove(parts.codes(part)[0]);
    }
    assertThat(slack).isLessThan(20);
  }

  /** A flight keeps all three half planes if and only if no control point goes beyond the gap. */
  @Test
  void itsBoundsAreThoseOfThePoints() {
    int kept = 0;
    for (int i = 0; i < 1000; i++) {
      turn();
      double nx = Math.cos(i);
      double ny = Math.sin(i);
      double gap = h * random.nextDouble();
      double least = Double.POSITIVE_INFINITY;
      double margin = Double.POSITIVE_INFINITY;
      for (int k = 0; k < Arc.POINTS; k++) {
        least = Math.min(least, nx * arc.wayX(k, ux, uy) + ny * arc.wayY(k, ux, uy) + gap);
        arc.bound(k, nx, ny, gap);
        assertThat(Math.hypot(arc.nx, arc.ny)).isCloseTo(1, within(1e-14));
        margin = Math.min(margin, (ux * arc.nx + uy * arc.ny - arc.drift) * h + gap);
      }
      assertThat(margin > 0).as("%s, %s", margin, least).isEqualTo(least > 0);
      arc.boundStrictly(nx, ny, gap, ux, uy);
      double strictest = (ux * arc.nx + uy * arc.ny - arc.drift) * h + gap;
      assertThat(strictest).isEqualTo(margin);
      kept += margin > 0 ? 1 : 0;
      obstacles.remove(parts.codes(part)[0]);
    }
    assertThat(kept).isBetween(300, 900);
  }

  /** In the middle it is the velocity along the normal, as seen from what turns. */
  @Test
  void inTheMiddleItIsTheVelocity() {
    for (int i = 0; i < 1000; i++) {
      turn();
      double nx = Math.cos(i);
      double ny = Math.sin(i);
      arc.middle(nx, ny, ux, uy);
      double step = 1e-5 * h;
      double[] before = seen(h / 2 - step);
      double[] after = seen(h / 2 + step);
      double speed = (nx * (after[0] - before[0]) + ny * (after[1] - before[1])) / (2 * step);
      assertThat(ux * arc.nx + uy * arc.ny - arc.drift).isCloseTo(speed, within(1e-7 / h));
      obstacles.remove(parts.codes(part)[0]);
    }
  }
}
