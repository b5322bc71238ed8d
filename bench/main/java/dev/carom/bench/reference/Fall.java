// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import java.util.ArrayList;
import java.util.List;

/** The path {@code p + v t + a t^2 / 2} of a circle that falls, and when it touches things. */
record Fall(Vec p, Vec v, Vec a) {

  Vec at(Ball t) {
    return p.plus(v.plus(a.times(t.half())).times(t));
  }

  /** The polynomial {@code n.(p(t) - from) - least}, from the constant term on. */
  Ball[] height(Vec n, Vec from, Ball least) {
    return new Ball[] {n.dot(p.minus(from)).minus(least), n.dot(v), n.dot(a).half()};
  }

  /** The polynomial {@code (p(t) - center)^2 - reach^2}, from the constant term on. */
  Ball[] distance(Vec center, Ball reach) {
    Vec d = p.minus(center);
    Ball dv = d.dot(v);
    return new Ball[] {
      d.dot(d).minus(reach.times(reach)),
      dv.plus(dv),
      v.dot(v).plus(d.dot(a)),
      v.dot(a),
      a.dot(a).half().half()
    };
  }

  /**
   * The times until an end at which a gap falls through 0.
   *
   * @param touching whether the gap is 0 at the start, by definition: that root is divided out
   */
  List<Ball> contacts(Ball[] gap, Ball end, boolean touching) {
    Ball[] f = touching ? Roots.withoutFirst(gap) : gap;
    List<Ball> roots = Roots.of(f, end);
    // Signs alternate from root to root; so the last one tells whether a root is a fall.
    int sign = Roots.signAfter(f, roots, end);
    List<Ball> falls = new ArrayList<>();
    for (int i = roots.size() - 1; i >= 0; i--) {
      if (sign < 0) {
        falls.add(0, roots.get(i));
      }
      sign = -sign;
    }
    return falls;
  }
}
