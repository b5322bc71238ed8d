// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.carom.oracle.Answer;
import dev.carom.oracle.Detector;
import dev.carom.oracle.MovingLineQuery;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.Part;
import dev.carom.oracle.SegmentQuery;
import dev.carom.oracle.WallQuery;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * {@link SweptCircle} as a judge sees it: its two forms, which must agree to the bit.
 *
 * @param pull gives the circle that is asked an acceleration, or none
 */
record LibraryDetector(UnaryOperator<SweptCircle> pull) implements Detector {

  static final LibraryDetector STRAIGHT = new LibraryDetector(UnaryOperator.identity());

  static LibraryDetector falling(double gx, double gy) {
    return new LibraryDetector(circle -> circle.withAcceleration(gx, gy));
  }

  private SweptCircle circle(double x, double y, double r, double vx, double vy) {
    return pull.apply(new SweptCircle(x, y, r, vx, vy));
  }

  @Override
  public Answer line(SegmentQuery q) {
    SweptCircle circle = circle(q.px(), q.py(), q.r(), q.vx(), q.vy());
    double time = circle.timeToLine(q.ax(), q.ay(), q.bx(), q.by(), q.end());
    return answer(time, circle.cast(new Line(q.ax(), q.ay(), q.bx(), q.by()), q.end()));
  }

  @Override
  public Answer movingLine(MovingLineQuery q) {
    SweptCircle circle = circle(q.px(), q.py(), q.r(), q.vx(), q.vy());
    double time = circle.timeToLine(q.ax(), q.ay(), q.bx(), q.by(), q.ux(), q.uy(), q.end());
    Line line = new Line(q.ax(), q.ay(), q.bx(), q.by());
    return answer(time, circle.cast(line, new Vec2(q.ux(), q.uy()), q.end()));
  }

  @Override
  public Answer pair(PairQuery q) {
    SweptCircle first = circle(q.x1(), q.y1(), q.r1(), q.vx1(), q.vy1());
    SweptCircle second = new SweptCircle(q.x2(), q.y2(), q.r2(), q.vx2(), q.vy2());
    Answer answer = answer(first.timeToCircle(second, q.end()), first.cast(second, q.end()));
    if (q.isPeg()) {
      double time = first.timeToPeg(q.x2(), q.y2(), q.r2(), q.end());
      Answer peg = answer(time, first.cast(new Circle(q.x2(), q.y2(), q.r2()), q.end()));
      assertEquals(answer, peg, "the second circle at rest is a peg");
    }
    return answer;
  }

  @Override
  public Answer bounds(WallQuery q) {
    SweptCircle circle = circle(q.px(), q.py(), q.r(), q.vx(), q.vy());
    double time = circle.timeToBounds(q.xmin(), q.ymin(), q.xmax(), q.ymax(), q.end());
    Bounds bounds = new Bounds(q.xmin(), q.ymin(), q.xmax(), q.ymax());
    return answer(time, circle.cast(bounds, q.end()));
  }

  private static Answer answer(double time, Optional<Impact> impact) {
    double castTime = impact.map(Impact::time).orElse(Double.POSITIVE_INFINITY);
    assertEquals(time, castTime, "the hot and the friendly form differ in time");
    return impact
        .map(i -> new Answer(time, Part.valueOf(i.feature().name()), i.nx(), i.ny()))
        .orElse(Answer.MISS);
  }
}
