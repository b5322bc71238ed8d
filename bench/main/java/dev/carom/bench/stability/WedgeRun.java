// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.Line;
import java.math.BigDecimal;
import java.math.MathContext;

/**
 * A circle between two lines of one apex, in 40 digits. Its state is how far it is from each line,
 * d, and how fast that grows, w: an impact on one turns its w into -e w, and takes (1 + e) w cos
 * from the other's, with cos that of the angle between their normals. At an impact d is 0 without a
 * rounding, so that impacts may pile up as they like. Once all the way that is left is less than
 * {@value #STILL} radii (with e <= 1 no impact makes it longer), the circle is taken to rest.
 */
final class WedgeRun {

  private static final MathContext DIGITS = new MathContext(40);

  /**
   * Relative change of a start value: far above the last digit, far below the spacing of doubles.
   */
  private static final String NUDGE = "1e-15";

  private static final double STILL = 1e-9;
  private static final int MOST_IMPACTS = 1_000_000;

  private final BigDecimal[] normalX = new BigDecimal[2];
  private final BigDecimal[] normalY = new BigDecimal[2];
  private final BigDecimal apexX;
  private final BigDecimal apexY;
  private final BigDecimal radius;
  private final BigDecimal e;
  private final BigDecimal cos;

  private final BigDecimal[] d = new BigDecimal[2];
  private final BigDecimal[] w = new BigDecimal[2];
  private BigDecimal[][] places;
  private double[][] states;
  private boolean pilesUp;

  WedgeRun(Line first, Line second, double radius, double restitution) {
    apexX = new BigDecimal(first.ax());
    apexY = new BigDecimal(first.ay());
    setNormal(0, first, 1);
    setNormal(1, second, -1);
    this.radius = new BigDecimal(radius);
    e = new BigDecimal(restitution);
    cos = dot(0, normalX[1], normalY[1]);
  }

  /** The unit perpendicular, to the left of the line or to its right. */
  private void setNormal(int i, Line line, int side) {
    BigDecimal wx = new BigDecimal(line.bx()).subtract(apexX);
    BigDecimal wy = new BigDecimal(line.by()).subtract(apexY);
    BigDecimal length = wx.multiply(wx).add(wy.multiply(wy)).sqrt(DIGITS);
    BigDecimal sign = BigDecimal.valueOf(side);
    normalX[i] = wy.negate().multiply(sign).divide(length, DIGITS);
    normalY[i] = wx.multiply(sign).divide(length, DIGITS);
  }

  private BigDecimal dot(int i, BigDecimal x, BigDecimal y) {
    return normalX[i].multiply(x).add(normalY[i].multiply(y)).round(DIGITS);
  }

  /** Plays from x, y, vx, vy, of which one may be nudged: its number, or -1 for none. */
  void play(double[] start, int nudged, int frames) {
    BigDecimal[] q = new BigDecimal[start.length];
    for (int i = 0; i < q.length; i++) {
      BigDecimal value = new BigDecimal(start[i]);
      q[i] = i == nudged ? value.add(value.multiply(new BigDecimal(NUDGE))) : value;
    }
    for (int i = 0; i < 2; i++) {
      d[i] = dot(i, q[0].subtract(apexX), q[1].subtract(apexY)).subtract(radius);
      w[i] = dot(i, q[2], q[3]);
    }
    places = new BigDecimal[frames + 1][];
    states = new double[frames + 1][];
    BigDecimal t = BigDecimal.ZERO;
    int impacts = 0;
    for (int frame = 0; frame <= frames; frame++) {
      BigDecimal end = BigDecimal.valueOf(frame);
      for (int hit = next(end.subtract(t)); hit >= 0; hit = next(end.subtract(t))) {
        t = t.add(impact(hit), DIGITS);
        rest(frames, t);
        if (++impacts > MOST_IMPACTS) {
          throw new IllegalStateException("more than " + MOST_IMPACTS + " impacts in a wedge");
        }
      }
      fly(end.subtract(t));
      t = end;
      record(frame);
    }
  }

  /** The line that is hit first within a time, -1 for none. */
  private int next(BigDecimal time) {
    int first = -1;
    BigDecimal least = time;
    for (int i = 0; i < 2; i++) {
      if (w[i].signum() < 0 && after(i).compareTo(least) <= 0) {
        least = after(i);
        first = i;
      }
    }
    return first;
  }

  private BigDecimal after(int i) {
    return d[i].divide(w[i].negate(), DIGITS).max(BigDecimal.ZERO);
  }

  private BigDecimal impact(int i) {
    BigDecimal after = after(i);
    fly(after);
    d[i] = BigDecimal.ZERO;
    BigDecimal push = w[i].multiply(BigDecimal.ONE.add(e));
    w[i] = w[i].multiply(e).negate().round(DIGITS);
    w[1 - i] = w[1 - i].subtract(push.multiply(cos)).round(DIGITS);
    return after;
  }

  private void fly(BigDecimal dt) {
    for (int i = 0; i < 2; i++) {
      d[i] = d[i].add(w[i].multiply(dt)).round(DIGITS);
    }
  }

  private void rest(int frames, BigDecimal t) {
    BigDecimal[] v = solve(w[0], w[1]);
    double speed = Math.hypot(v[0].doubleValue(), v[1].doubleValue());
    if (speed > 0 && speed * (frames - t.doubleValue()) < STILL * radius.doubleValue()) {
      pilesUp = true;
      w[0] = BigDecimal.ZERO;
      w[1] = BigDecimal.ZERO;
    }
  }

  /** The vector whose products with the two normals are given. */
  private BigDecimal[] solve(BigDecimal a, BigDecimal b) {
    BigDecimal det = normalX[0].multiply(normalY[1]).subtract(normalY[0].multiply(normalX[1]));
    BigDecimal x = a.multiply(normalY[1]).subtract(b.multiply(normalY[0]));
    BigDecimal y = b.multiply(normalX[0]).subtract(a.multiply(normalX[1]));
    return new BigDecimal[] {x.divide(det, DIGITS), y.divide(det, DIGITS)};
  }

  private void record(int frame) {
    BigDecimal[] p = solve(d[0].add(radius), d[1].add(radius));
    p[0] = p[0].add(apexX);
    p[1] = p[1].add(apexY);
    BigDecimal[] v = solve(w[0], w[1]);
    places[frame] = p;
    states[frame] =
        new double[] {
          p[0].doubleValue(), p[1].doubleValue(), v[0].doubleValue(), v[1].doubleValue()
        };
  }

  /** x, y, vx, vy by frame. */
  double[][] states() {
    return states;
  }

  boolean pilesUp() {
    return pilesUp;
  }

  /** Adds, for each frame, how far the place is from that of another run, by the nudge. */
  void addDistances(WedgeRun other, double[] sums) {
    double nudge = Double.parseDouble(NUDGE);
    for (int frame = 0; frame < sums.length; frame++) {
      double dx = places[frame][0].subtract(other.places[frame][0]).doubleValue();
      double dy = places[frame][1].subtract(other.places[frame][1]).doubleValue();
      sums[frame] += Math.hypot(dx, dy) / nudge;
    }
  }
}
