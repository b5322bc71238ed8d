// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Circle;
import dev.carom.Impact;
import dev.carom.Line;
import dev.carom.SweptCircle;
import dev.carom.Vec2;
import java.util.List;
import java.util.Optional;

/** The two questions that a file can ask, and the columns in which it does. */
enum CastQuery {
  /** A moving circle, which may be accelerated, against a line, which may move instead. */
  LINE("ax,ay,bx,by,px,py,r,vx,vy,T", "ux,uy,gx,gy") {
    @Override
    Optional<Impact> cast(double[] q) {
      Circle circle = new Circle(q[4], q[5], q[6]);
      Line line = new Line(q[0], q[1], q[2], q[3]);
      Vec2 v = new Vec2(q[7], q[8]);
      if (q[12] == 0 && q[13] == 0) {
        return SweptCircle.cast(circle, v, line, new Vec2(q[10], q[11]), q[9]);
      }
      return SweptCircle.cast(circle, v, new Vec2(q[12], q[13]), line, q[9]);
    }

    @Override
    boolean asksTooMuch(double[] q) {
      return (q[10] != 0 || q[11] != 0) && (q[12] != 0 || q[13] != 0);
    }
  },
  /** Two moving circles; one acceleration of both has no effect on the answer. */
  PAIR("x1,y1,r1,vx1,vy1,x2,y2,r2,vx2,vy2,T", "gx,gy") {
    @Override
    Optional<Impact> cast(double[] q) {
      Circle first = new Circle(q[0], q[1], q[2]);
      Circle second = new Circle(q[5], q[6], q[7]);
      return SweptCircle.cast(first, new Vec2(q[3], q[4]), second, new Vec2(q[8], q[9]), q[10]);
    }
  };

  private final String header;
  private final String optional;

  CastQuery(String header, String optional) {
    this.header = header;
    this.optional = optional;
  }

  /** The names of the columns with which a file begins, in order. */
  String header() {
    return header;
  }

  /** The names of further columns that have a meaning; a file may have them anywhere, or not. */
  List<String> optional() {
    return List.of(optional.split(","));
  }

  /** Whether a line moves and the circle is accelerated: there is no detector for both. */
  boolean asksTooMuch(double[] query) {
    return false;
  }

  /** Asks the question: one number for each column of the header, then for each optional one. */
  abstract Optional<Impact> cast(double[] query);

  /** The range of the numbers in a column, in words. */
  static String expectation(String column) {
    return switch (column.charAt(0)) {
      case 'r' -> "a finite number, at least 0";
      case 'T' -> "a number, at least 0";
      default -> "a finite number";
    };
  }

  /** Whether a number is what its column expects. */
  static boolean accepts(String column, double value) {
    boolean finite = Math.abs(value) <= Double.MAX_VALUE;
    return switch (column.charAt(0)) {
      case 'r' -> finite && value >= 0;
      case 'T' -> value >= 0;
      default -> finite;
    };
  }
}
