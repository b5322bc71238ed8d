// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Impact;
import dev.carom.Line;
import dev.carom.SweptCircle;
import dev.carom.Vec2;
import java.util.List;
import java.util.Optional;

/** The two questions that a file can ask, and the columns in which it does. */
enum CastQuery {
  /** A moving circle, which may be accelerated, against a line, which may move, too. */
  LINE("ax,ay,bx,by,px,py,r,vx,vy,T", "ux,uy,gx,gy") {
    @Override
    Optional<Impact> cast(double[] q) {
      return new SweptCircle(q[4], q[5], q[6], q[7], q[8], q[12], q[13])
          .cast(new Line(q[0], q[1], q[2], q[3]), new Vec2(q[10], q[11]), q[9]);
    }
  },
  /** Two moving circles; one acceleration of both has no effect on the answer. */
  PAIR("x1,y1,r1,vx1,vy1,x2,y2,r2,vx2,vy2,T", "gx,gy") {
    @Override
    Optional<Impact> cast(double[] q) {
      return new SweptCircle(q[0], q[1], q[2], q[3], q[4])
          .cast(new SweptCircle(q[5], q[6], q[7], q[8], q[9]), q[10]);
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
