// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.KindNumber;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The contact of one circle with lines that turn, without a search for impacts. */
class TurningContactTest {

  private static final double R = 1;

  private final ObstacleTable obstacles = ObstacleTable.empty(null);
  private final MovingCircle m = new MovingCircle();
  private final ImpactRows log = new ImpactRows(1);
  private final Gravity gravity = new Gravity(0, 0);
  private double restitution;
  private double deepest;
  private int ticks;

  /** A line from the pivot (0, 0) along the x axis, which turns by an angle in a time. */
  private int line(double length, double angle, double time) {
    int line = obstacles.add(KindNumber.LINE, 0, 0, length, 0);
    turn(line, 0, 0, angle, 0, time);
    return line;
  }

  private void turn(int line, double px, double py, double angle, double now, double until) {
    double[] numbers = obstacles.rowAt(line, now, 0);
    for (int k = 0; k < 4; k += 2) {
      ObstacleMotions.turn(px, py, Math.cos(angle / 2), Math.sin(angle / 2), numbers, k);
    }
    double[] motion = new double[ObstacleMotions.SIZE];
    ObstacleMotions.setTurn(motion, px, py, angle, now, until);
    obstacles.moveTo(line, numbers, motion);
  }

  private LoneContact join(double x, double y, double vx, double vy) {
    LoneContact contact =
        new LoneContact(
            obstacles,
            null,
            gravity,
            (circle, reach, now, into) -> obstacles.codes(KindNumber.LINE).forEach(into::add));
    m.start(0, x, y, R, vx, vy, restitution);
    m.fall(gravity.x, gravity.y);
    contact.join(m, log);
    return contact;
  }

  /** Plays ticks until a time, or until the circle leaves contact. */
  private void play(LoneContact contact, double end) {
    while (m.isMember() && m.due() <= end) {
      check();
      contact.tick(m, log);
      ticks++;
      assertThat(ticks).isLessThan(100_000);
    }
  }

  private void check() {
    double h = m.due() - m.t;
    for (int k = 0; k <= 100; k++) {
      double t = h * k / 100;
      double x = m.x + m.vx * t;
      double y = m.y + m.vy * t;
      obstacles
          .codes(KindNumber.LINE)
          .forEach(
              code -> {
                double[] row = obstacles.rowAt(code, m.t + t, 0);
                deepest = Math.max(deepest, R - distance(row, x, y));
              });
    }
  }

  private static double distance(double[] row, double x, double y) {
    double wx = row[2] - row[0];
    double wy = row[3] - row[1];
    double part = ((x - row[0]) * wx + (y - row[1]) * wy) / (wx * wx + wy * wy);
    double s = Math.max(0, Math.min(1, part));
    return Math.hypot(x - row[0] - s * wx, y - row[1] - s * wy);
  }

  /**
   * A circle that stays on a line that turns at the rate w: {@code s' = u + w r, u' = w^2 s} for
   * its place s along the line and its speed u, less {@code g sin} of the angle.
   */
  private double[] slide(int line, double from, double speed, double end) {
    double s = from;
    double u = speed;
    int steps = 20_000;
    double h = end / steps;
    for (int k = 0; k < steps; k++) {
      double[] row = obstacles.rowAt(line, (k + 0.5) * h, 0);
      double sine = row[3] / Math.hypot(row[2], row[3]);
      double w = obstacles.rate(line, (k + 0.5) * h, 0);
      double sm = s + (u + w * R) * h / 2;
      double um = u + (w * w * s + gravity.y * sine) * h / 2;
      s += (um + w * R) * h;
      u += (w * w * sm + gravity.y * sine) * h;
    }
    return new double[] {s, u};
  }

  private double along(int line) {
    double[] row = obstacles.rowAt(line, m.t, 0);
    return (m.x * row[2] + m.y * row[3]) / Math.hypot(row[2], row[3]);
  }

  /** Without gravity and without bounce it stays on, and slides outwards. */
  @ParameterizedTest
  @CsvSource({"5, 1", "5, 10", "20, 1", "100, 1", "1.5, 0.1"})
  void itSlidesOutwardsAsTheEquationSays(double from, double rate) {
    int line = line(10 * from, 1, 1 / rate);
    double w = obstacles.rate(line, 0, 0);
    LoneContact contact = join(from, R, 0, w * from);
    play(contact, 0.99 / rate);
    assertThat(m.isMember()).isTrue();
    double[] expected = slide(line, from, 0, m.t);
    assertThat(along(line) / expected[0]).isCloseTo(1, within(1e-3));
    assertThat(deepest).isLessThan(1e-10);
  }

  /** It rolls down a line that tilts, with gravity. */
  @ParameterizedTest
  @CsvSource({"1, 1", "-1, 1", "0.3, 10", "-0.3, 10", "0.01, 1"})
  void itRollsOnALineThatTilts(double angle, double g) {
    gravity.set(0, -g);
    int line = line(1000, angle, 2);
    LoneContact contact = join(100, R, 0, obstacles.rate(line, 0, 0) * 100);
    play(contact, 1.9);
    boolean stays = angle > -0.5;
    assertThat(m.isMember()).isEqualTo(stays);
    double[] expected = slide(line, 100, 0, m.t);
    if (stays) {
      assertThat(along(line) / expected[0]).isCloseTo(1, within(1e-3));
    }
    assertThat(deepest).isLessThan(1e-10);
  }

  /**
   * Inwards, on a line that rises, straight flights are nearest to that in the middle of a tick.
   */
  @ParameterizedTest
  @CsvSource({"126, 60", "126, 62", "126, 64", "31, 15", "31, 16"})
  void whereItRollsInwardsItDoesNotOverlap(double g, double speed) {
    gravity.set(0, -g);
    int line = line(1000, 1, 1);
    LoneContact contact = join(80, R, -speed, obstacles.rate(line, 0, 0) * 80);
    play(contact, 0.3);
    assertThat(ticks).isGreaterThan(20);
    assertThat(m.isMember()).isTrue();
    assertThat(deepest).isLessThan(1e-10);
  }

  /** In a wedge that closes it is pushed out at r w / (2 sin^2(angle / 2)). */
  @ParameterizedTest
  @CsvSource({"0", "10"})
  void aWedgeThatClosesPushesItOut(double g) {
    gravity.set(-g, 0);
    double opening = 1.2;
    double angle = 0.6;
    int line = obstacles.add(KindNumber.LINE, 0, 0, 40 * Math.cos(opening), 40 * Math.sin(opening));
    obstacles.add(KindNumber.LINE, 0, 0, 40, 0);
    turn(line, 0, 0, -angle, 0, 1);
    double from = R / Math.tan(opening / 2);
    LoneContact contact = join(from, R, 0, 0);
    play(contact, 0.9);
    assertThat(m.isMember()).isTrue();
    double[] row = obstacles.rowAt(line, m.t, 0);
    double now = Math.atan2(row[3], row[2]);
    double half = Math.sin(now / 2);
    double speed = -obstacles.rate(line, m.t, 0) * R / (2 * half * half);
    if (g > 0) {
      assertThat(m.x).isCloseTo(R / Math.tan(now / 2), within(0.05));
      assertThat(m.vx).isCloseTo(speed, within(0.05 * speed));
    }
    assertThat(m.x).isGreaterThan(R / Math.tan(now / 2) - 1e-9);
    assertThat(m.y).isGreaterThan(R - 1e-9);
    assertThat(deepest).isLessThan(1e-10);
  }

  /** Against a stop it is crushed: the line passes over it, and the log says so. */
  @Test
  void againstAStopItIsCrushed() {
    int line = line(20, 1, 1);
    obstacles.add(KindNumber.LINE, 8.9, 3, 11.1, 3); // in a slot that is not much wider
    obstacles.add(KindNumber.LINE, 11.1, -3, 11.1, 3);
    obstacles.add(KindNumber.LINE, 8.9, -3, 8.9, 3);
    LoneContact contact = join(10, R, 0, obstacles.rate(line, 0, 0) * 10);
    while (m.isMember() && m.mode != MovingCircle.JAMMED && m.due() < 1) {
      check();
      contact.tick(m, log);
    }
    assertThat(m.mode).isEqualTo(MovingCircle.JAMMED);
    assertThat(deepest).isLessThan(1e-10);
    assertThat(log.size()).isEqualTo(1);
    assertThat(log.outcome(0)).isEqualTo(ImpactRows.JAMMED);
  }

  /** Whatever joins anywhere near: it never overlaps, and in the end it leaves. */
  @ParameterizedTest
  @CsvSource({"0", "1", "30"})
  void nothingOverlapsAnywhere(double g) {
    Random random = new Random(1);
    for (int i = 0; i < 300; i++) {
      obstacles.set(ObstacleTable.empty(null));
      restitution = random.nextDouble();
      gravity.set(0, -g);
      double angle = (random.nextDouble() - 0.5) * Math.PI;
      int line = line(1 + 20 * random.nextDouble(), angle, Math.pow(10, -2 * random.nextDouble()));
      if (random.nextBoolean()) {
        double[] row = obstacles.rowAt(line, 0, 0);
        double direction = random.nextDouble() * 6;
        int other =
            obstacles.add(
                KindNumber.LINE,
                row[2],
                0,
                row[2] + 9 * Math.cos(direction),
                9 * Math.sin(direction));
        turn(other, 0, 0, angle, 0, obstacles.arrival(line));
      }
      double x = random.nextDouble() * 22 - 1;
      double y = R * (1 + Math.pow(10, -9 * random.nextDouble())) * (random.nextBoolean() ? 1 : -1);
      boolean isClear =
          obstacles
              .codes(KindNumber.LINE)
              .allMatch(code -> distance(obstacles.rowAt(code, 0, 0), x, y) >= R);
      if (!isClear) {
        continue;
      }
      double speed = Math.pow(10, 3 * random.nextDouble() - 1);
      LoneContact contact =
          join(x, y, speed * random.nextGaussian(), speed * random.nextGaussian());
      play(contact, obstacles.arrival(line) * 0.999);
      assertThat(deepest).as("run %s", i).isLessThan(1e-10);
      assertThat(log.size()).as("run %s is crushed", i).isZero();
      ticks = 0;
    }
  }
}
