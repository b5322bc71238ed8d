// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.Arrays;
import java.util.Locale;
import java.util.StringJoiner;

/**
 * A question about a circle (p, r) with the velocity v and the acceleration g, and a line a-b, or a
 * disk around a = b, that turns about a pivot: a vector w of it, seen from the pivot, is {@code w
 * c^2 / |c|^2} with {@code c = 1 + (q1 + i q2) t}.
 *
 * @param kind which contact is asked for
 * @param after of an entry the time after which it counts
 */
public record TurningQuery(
    Kind kind,
    double ax,
    double ay,
    double bx,
    double by,
    double radius,
    double px,
    double py,
    double r,
    double vx,
    double vy,
    double gx,
    double gy,
    double pivotX,
    double pivotY,
    double q1,
    double q2,
    double after,
    double end)
    implements Question {

  public TurningQuery {
    if (radius != 0 && (ax != bx || ay != by)) {
      throw new IllegalArgumentException("a line has no radius: " + radius);
    }
  }

  /** The first contact, the next one with what is touched at the start, or a later entry. */
  public enum Kind {
    FIRST,
    RETURN,
    ENTRY
  }

  // The places of some numbers.
  static final int P = 5;
  static final int V = 8;
  static final int G = 10;
  static final int AFTER = 16;
  static final int END = 17;

  /** The query of a kind with these {@link #numbers}. */
  public static TurningQuery of(Kind kind, double... n) {
    return new TurningQuery(
        kind, n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10], n[11], n[12],
        n[13], n[14], n[15], n[16], n[17]);
  }

  /** All numbers. */
  public double[] numbers() {
    return new double[] {
      ax, ay, bx, by, radius, px, py, r, vx, vy, gx, gy, pivotX, pivotY, q1, q2, after, end
    };
  }

  TurningQuery with(int i, double value) {
    double[] n = numbers();
    n[i] = value;
    return of(kind, n);
  }

  TurningQuery as(Kind newKind) {
    return of(newKind, numbers());
  }

  public boolean isLine() {
    return ax != bx || ay != by;
  }

  /**
   * All but the end of the window are finite, no radius is negative, and it turns: as a move of at
   * most a quarter turn does, in which |c| is never far below 1.
   */
  @Override
  public boolean isFair() {
    double[] n = numbers();
    double nearest = Math.min(Math.max(0, -q1 / (q1 * q1 + q2 * q2)), end);
    return Math.hypot(1 + q1 * nearest, q2 * nearest) > 0.5
        && Arrays.stream(n, 0, END).allMatch(Double::isFinite)
        && r >= 0
        && radius >= 0
        && q2 != 0
        && end >= 0;
  }

  @Override
  public ParabolaContact truth() {
    CurveOracle oracle = CurveOracle.of(this);
    return switch (kind) {
      case FIRST -> oracle.first();
      case RETURN -> oracle.back();
      case ENTRY -> oracle.entry(after);
    };
  }

  @Override
  public String hex() {
    StringJoiner all = new StringJoiner(", ", kind + " ", "");
    for (double n : numbers()) {
      all.add(Double.toHexString(n).toLowerCase(Locale.ROOT));
    }
    return all.toString();
  }
}
