// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.SweptCircle;
import dev.carom.SweptSphere;
import java.util.Arrays;

/**
 * Every hot form of the detector, asked with numbers of all patterns. Each answer must be a time
 * within the window, or never: no exception, no NaN; and what is out of its range must be refused
 * by name.
 */
public final class QueryFuzz {

  private static final double[] NO_NUMBERS = {
    Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY
  };

  /** One in so many queries has a number that is none. */
  private static final int REFUSED = 64;

  private final Bits bits;
  private long queries;
  private long hits;
  private long refused;

  /** Starts a row of queries. */
  public QueryFuzz(long seed) {
    bits = new Bits(seed);
  }

  /**
   * Asks some more.
   *
   * @throws FindingException if an answer is none
   */
  public void ask(long count) throws FindingException {
    for (long i = 0; i < count; i++) {
      ask();
    }
  }

  private void ask() throws FindingException {
    bits.begin();
    Form form = Form.values()[bits.below(Form.values().length)];
    double[] n = form.draw(bits);
    boolean bad = bits.chance(REFUSED);
    if (bad) {
      n[bits.below(n.length - (form.hasWindow() ? 1 : 0))] = NO_NUMBERS[bits.below(3)];
    }
    double t;
    try {
      t = form.ask(n);
    } catch (IllegalArgumentException e) {
      t = Double.NaN;
      if (!bad || e.getMessage() == null) {
        throw new FindingException(text(form, n) + ": " + e, e);
      }
    } catch (RuntimeException | Error e) {
      throw new FindingException(text(form, n) + ": " + e, e);
    }
    double end = form.hasWindow() ? n[n.length - 1] : 1;
    boolean hit = t >= 0 && t <= end && t < Double.POSITIVE_INFINITY;
    if (bad != Double.isNaN(t) || !(bad || hit || t == Double.POSITIVE_INFINITY)) {
      throw new FindingException(text(form, n) + ": the answer is " + t);
    }
    queries++;
    hits += hit ? 1 : 0;
    refused += bad ? 1 : 0;
  }

  private static String text(Form form, double... numbers) {
    return form + Arrays.stream(numbers).mapToObj(Double::toHexString).toList().toString();
  }

  public long queries() {
    return queries;
  }

  public long hits() {
    return hits;
  }

  public long refused() {
    return refused;
  }

  /** A hot form, and the numbers that it takes. Overlaps count as a hit at 0. */
  private enum Form {
    LINE("xxrxxxxxxT") {
      @Override
      double ask(double... n) {
        return SweptCircle.line(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9]);
      }
    },
    PEG("xxrxxxxrT") {
      @Override
      double ask(double... n) {
        return SweptCircle.peg(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]);
      }
    },
    BOUNDS("xxrxxbbttT") {
      @Override
      double ask(double... n) {
        return SweptCircle.bounds(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9]);
      }
    },
    PAIR("xxrxxxxrxxT") {
      @Override
      double ask(double... n) {
        return SweptCircle.pair(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10]);
      }
    },
    SPHERE("xxxrxxxxxxrxxxT") {
      @Override
      double ask(double... n) {
        return SweptSphere.pair(
            n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10], n[11], n[12], n[13],
            n[14]);
      }
    },
    CIRCLES_OVERLAP("xxrxxr") {
      @Override
      double ask(double... n) {
        return timeOf(SweptCircle.overlaps(n[0], n[1], n[2], n[3], n[4], n[5]));
      }
    },
    SPHERES_OVERLAP("xxxrxxxr") {
      @Override
      double ask(double... n) {
        return timeOf(SweptSphere.overlaps(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]));
      }
    };

    /** x any, r a radius, T the window; b a lower bound, t the upper one that belongs to it. */
    private final String numbers;

    Form(String numbers) {
      this.numbers = numbers;
    }

    abstract double ask(double... n);

    boolean hasWindow() {
      return numbers.endsWith("T");
    }

    double[] draw(Bits bits) {
      double[] n = new double[numbers.length()];
      for (int i = 0; i < n.length; i++) {
        n[i] =
            switch (numbers.charAt(i)) {
              case 'r' -> bits.length();
              case 'T' -> bits.window();
              default -> bits.any();
            };
      }
      for (int i = numbers.indexOf('t'); i >= 0 && i < n.length && numbers.charAt(i) == 't'; i++) {
        order(n, i - 2, i);
      }
      return n;
    }

    /** The upper bound is greater than the lower one. */
    private static void order(double[] n, int low, int high) {
      double least = Math.min(n[low], n[high]);
      double most = Math.max(n[low], n[high]);
      n[low] = least == Double.MAX_VALUE ? 0 : least;
      n[high] = most == n[low] ? Math.nextUp(most) : most;
    }

    private static double timeOf(boolean overlap) {
      return overlap ? 0 : Double.POSITIVE_INFINITY;
    }
  }
}
