// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The times above 0 and before an end at which a polynomial changes its sign. Between two such
 * roots of its derivative a polynomial is monotone: so signs at these tell in which intervals there
 * is one. It is found by bisection and Newton's method. Signs a little before and after it prove
 * it.
 *
 * <p>Polynomials are arrays of their coefficients, from the constant term on.
 */
final class Roots {

  /** Far more than it takes. */
  private static final int BISECTIONS = 60;

  /** Each step doubles the right bits. */
  private static final int NEWTON_STEPS = 20;

  /** By how many bits the interval that holds a root is widened until that is proved. */
  private static final int WIDER = 4;

  private Roots() {}

  /** The polynomial divided by t: for one that is 0 at 0. */
  static Ball[] withoutFirst(Ball[] f) {
    return Arrays.copyOfRange(f, 1, f.length);
  }

  /** The roots at which the sign changes, ascending. */
  static List<Ball> of(Ball[] f, Ball end) {
    List<Ball> roots = new ArrayList<>();
    if (f.length == 1) {
      return roots;
    }
    List<Ball> points = of(derivative(f), end);
    points.add(end);
    Ball before = end.whole(0);
    int signBefore = value(f, before).sign();
    for (Ball point : points) {
      int sign = value(f, point).sign();
      if (sign * signBefore < 0) {
        roots.add(refined(f, before.middle(), point.middle(), signBefore));
      }
      // A point at which it is 0 is a root of the derivative, too: a graze, unless signs differ.
      signBefore = sign == 0 ? signBefore : sign;
      before = sign == 0 ? before : point;
    }
    return roots;
  }

  /** The sign between the last root and the end. */
  static int signAfter(Ball[] f, List<Ball> roots, Ball end) {
    return roots.isEmpty() ? 0 : value(f, end).sign();
  }

  private static Ball[] derivative(Ball[] f) {
    Ball[] derivative = new Ball[f.length - 1];
    for (int i = 0; i < derivative.length; i++) {
      derivative[i] = f[i + 1].times(f[i + 1].whole(i + 1));
    }
    return derivative;
  }

  private static Ball value(Ball[] f, Ball t) {
    Ball sum = f[f.length - 1];
    for (int i = f.length - 2; i >= 0; i--) {
      sum = sum.times(t).plus(f[i]);
    }
    return sum;
  }

  /** The one root between two numbers, the sign before it given. */
  private static Ball refined(Ball[] f, Ball from, Ball to, int signBefore) {
    Ball low = from;
    Ball high = to;
    for (int i = 0; i < BISECTIONS; i++) {
      Ball middle = low.plus(high).half().middle();
      int sign = value(f, middle).certainSign();
      if (sign == 0) {
        break;
      }
      low = sign == signBefore ? middle : low;
      high = sign == signBefore ? high : middle;
    }
    return proved(f, newton(f, low.plus(high).half().middle()), from, to, signBefore);
  }

  private static Ball newton(Ball[] f, Ball start) {
    Ball[] slope = derivative(f);
    Ball t = start;
    for (int i = 0; i < NEWTON_STEPS; i++) {
      Ball rise = value(slope, t).middle();
      if (rise.sign() == 0) {
        throw new DoubtException();
      }
      Ball step = value(f, t).middle().over(rise).middle();
      t = t.minus(step).middle();
      if (step.abs().compareTo(t.step(2)) <= 0) {
        break;
      }
    }
    return t;
  }

  /** A number with an error so wide that signs prove the root within. */
  private static Ball proved(Ball[] f, Ball root, Ball from, Ball to, int signBefore) {
    for (int wide = WIDER; wide < 2 * root.bits(); wide += WIDER) {
      Ball low = root.minus(root.step(wide));
      Ball high = root.plus(root.step(wide));
      if (low.compareTo(from) < 0 || high.compareTo(to) > 0) {
        break;
      }
      if (value(f, low).certainSign() == signBefore
          && value(f, high).certainSign() == -signBefore) {
        return root.widened(wide);
      }
    }
    throw new DoubtException();
  }
}
