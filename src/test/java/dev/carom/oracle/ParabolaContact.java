// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * The exact answer to a {@link ParabolaQuery}.
 *
 * @param part what is hit
 * @param moment when: null for time 0, and for a miss
 * @param normal the unit normal; null for a miss
 */
public record ParabolaContact(Part part, SturmRoot moment, Normal normal) implements Truth {
  static final ParabolaContact MISS = new ParabolaContact(Part.NONE, null, null);

  @Override
  public double time() {
    if (!hit()) {
      return Double.POSITIVE_INFINITY;
    }
    if (moment == null) {
      return 0;
    }
    return moment.nearest();
  }

  @Override
  public double errorInUlps(double time) {
    if (!Double.isFinite(time)) {
      return Double.POSITIVE_INFINITY;
    }
    Dyadic truth = moment == null ? Dyadic.ZERO : moment.narrow(120).low();
    Dyadic error = Dyadic.of(time).minus(truth);
    return error.signum() == 0 ? 0 : error.over(Dyadic.of(Math.ulp(time())), 64).near();
  }

  boolean within(double end) {
    return moment == null
        || (end == Double.POSITIVE_INFINITY
            ? Double.isFinite(time())
            : moment.compareTo(Dyadic.of(end)) <= 0);
  }
}
