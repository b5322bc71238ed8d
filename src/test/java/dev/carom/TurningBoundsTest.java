// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.sweep.TurningFalls;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Family;
import dev.carom.oracle.TurningFamilies;
import dev.carom.oracle.TurningQuery;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * The rounding bounds of things that turn. None is violated: the ladder answers as exact numbers
 * alone do. None is idle: without it a query is answered wrongly.
 *
 * <p>More queries, and others: {@code -Dcarom.queries=1000000 -Dcarom.seed=2}. Those of some
 * families alone: {@code -Dcarom.families=.*touching.*}.
 */
@Tag("long")
class TurningBoundsTest {
  private static final String FAMILIES =
      System.getProperty("carom.families", "far_pivot|graze_side");
  private static final long QUERIES = Long.getLong("carom.queries", 6_000);
  private static final long SEED = Long.getLong("carom.seed", 1);
  private static final double U = 0x1p-53;

  /** Constants of a class that are left out together. */
  private record Weakening(String name, String owner, List<Double> values) {}

  private static final List<Weakening> WEAKENINGS =
      List.of(
          new Weakening("signs on an interval", "GapPolynomial", List.of(16 * U, 9 * U, 24 * U)),
          new Weakening("residue", "TurningRoot", List.of(160 * U * U)),
          new Weakening("beside a root", "GapRoot", List.of(2560.0)),
          new Weakening("projection", "Fall", List.of(32 * U)),
          new Weakening("distance in the window", "TurnWindow", List.of(0x1p-40, 0x1p-500)));

  @Test
  void everyBoundHoldsAndIsNeeded() throws ReflectiveOperationException {
    Map<String, Method> without = new TreeMap<>();
    for (Weakening weakening : WEAKENINGS) {
      without.put(weakening.name(), detector(weakening));
    }
    List<String> violations = new ArrayList<>();
    Map<String, String> mistakes = new TreeMap<>();
    List<Family<TurningQuery>> families =
        TurningFamilies.all().stream().filter(f -> f.name().matches(FAMILIES)).toList();
    for (Family<TurningQuery> family : families) {
      Draw draw = Draw.of(SEED, family.name());
      for (int i = 0; i < QUERIES / families.size(); i++) {
        TurningQuery query = family.next(draw);
        double[] n = query.numbers();
        int kind = query.kind().ordinal();
        double[] said = TurningFalls.answer(kind, n);
        if (said[0] != TurningFalls.exactTime(kind, n)) {
          violations.add(family.name() + ": " + query.hex());
        }
        for (Map.Entry<String, Method> each : without.entrySet()) {
          if (!mistakes.containsKey(each.getKey()) && isMistaken(each.getValue(), kind, n, said)) {
            mistakes.put(each.getKey(), family.name() + ": " + query.hex());
          }
        }
      }
    }
    mistakes.forEach((name, query) -> System.out.println("without " + name + ": " + query));
    assertThat(violations).isEmpty();
    assertThat(mistakes).containsOnlyKeys(without.keySet());
  }

  private static boolean isMistaken(Method detector, int kind, double[] n, double[] truth) {
    try {
      double[] said = (double[]) detector.invoke(null, kind, n);
      return said[0] != truth[0] || said[1] != truth[1];
    } catch (ReflectiveOperationException e) {
      return true; // it ran into numbers that cannot be
    }
  }

  private static Method detector(Weakening weakening) throws ReflectiveOperationException {
    ClassLoader classes =
        new PatchedClasses(
            (name, pool) -> {
              if (name.endsWith("." + weakening.owner())) {
                weakening.values().forEach(value -> pool.replace(value, 0));
              }
            });
    return classes
        .loadClass(TurningFalls.class.getName())
        .getMethod("answer", int.class, double[].class);
  }
}
