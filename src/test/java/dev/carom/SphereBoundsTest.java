// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.oracle.Draw;
import dev.carom.oracle.SphereFamilies;
import dev.carom.oracle.SphereQuery;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/**
 * The bounds of {@link RoundingBoundsTest}, in space: none is violated, and without any of them a
 * query about two spheres is answered wrongly. ROOT_PLACE is seen in the plane only: in space, what
 * one correction leaves open goes to numbers without rounding.
 *
 * <p>More queries, and others: {@code -Dcarom.queries=10000000 -Dcarom.seed=3}.
 */
class SphereBoundsTest {
  private static final int QUERIES =
      (int) (Long.getLong("carom.queries", 48_000) / SphereFamilies.NAMES.size());
  private static final long SEED = Long.getLong("carom.seed", 2);
  private static final List<RoundingBound> BOUNDS =
      List.of(
          RoundingBound.ROOT_DOT,
          RoundingBound.ROOT_GAP,
          RoundingBound.ROOT_REACH,
          RoundingBound.ROOT_TINY);

  private final PatchedDetector whole = PatchedDetector.scaled(RoundingBound.ROOT_DOT, 1);
  private final PatchedDetector exact = PatchedDetector.exact();

  private static List<SphereQuery> queries(String family) {
    Draw draw = Draw.of(SEED, family);
    return IntStream.range(0, QUERIES).mapToObj(i -> SphereFamilies.next(family, draw)).toList();
  }

  @Test
  void everyBoundHoldsAndIsNeeded() {
    Map<RoundingBound, PatchedDetector> without = new EnumMap<>(RoundingBound.class);
    BOUNDS.forEach(bound -> without.put(bound, PatchedDetector.scaled(bound, 0)));
    List<String> violations = new ArrayList<>();
    Map<RoundingBound, SphereQuery> mistakes = new EnumMap<>(RoundingBound.class);
    for (String family : SphereFamilies.NAMES) {
      for (SphereQuery query : queries(family)) {
        double truth = exact.ask(query);
        if (whole.ask(query) != truth) {
          violations.add(family + ": " + List.of(query.numbers()));
        }
        without.forEach(
            (bound, detector) -> {
              if (!mistakes.containsKey(bound) && detector.ask(query) != truth) {
                mistakes.put(bound, query);
              }
            });
      }
    }
    assertThat(violations).isEmpty();
    assertThat(mistakes).containsOnlyKeys(BOUNDS);
    mistakes.forEach((bound, query) -> assertThat(exact.ask(query)).isEqualTo(query.truth()));
  }
}
