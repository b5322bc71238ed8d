// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.SweptCircle;
import dev.carom.SweptSphere;
import dev.carom.TestScenes;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.oracle.Brinks;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.Query;
import dev.carom.oracle.SegmentQuery;
import dev.carom.oracle.SphereFamilies;
import dev.carom.oracle.WallQuery;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * How many questions of each family climb beyond plain doubles. A bound of rounding errors that is
 * larger than it was sends more of them up; that costs time, and nothing else would notice. One
 * that is smaller sends fewer: its derivation must allow that before the numbers here are changed.
 */
@EnabledIfSystemProperty(named = "dev.carom.rungs", matches = "true")
class PrecisionCounterTest {
  private static final int QUERIES = 200;

  /**
   * The counts in a column of the file.
   *
   * @param doubtful decisions that plain doubles left open
   * @param exact of them, those that double-double left open too
   * @param roots of doubles
   * @param doubtfulTimes times of impact that double-double could not round
   * @param times of them, those that sums without rounding left open too
   * @param normals likewise
   */
  private record Counts(
      long doubtful, long exact, long roots, long doubtfulTimes, long times, long normals) {

    static Counts now() {
      return new Counts(
          PrecisionCounter.DOUBTFUL_DECISIONS.count(),
          PrecisionCounter.EXACT_DECISIONS.count(),
          PrecisionCounter.ROOTS.count(),
          PrecisionCounter.DOUBTFUL_TIMES.count(),
          PrecisionCounter.EXACT_TIMES.count(),
          PrecisionCounter.EXACT_NORMALS.count());
    }

    static Counts of(Draw draw, Consumer<Draw> question) {
      Counts before = now();
      for (int i = 0; i < QUERIES; i++) {
        question.accept(draw);
      }
      Counts after = now();
      return new Counts(
          after.doubtful - before.doubtful,
          after.exact - before.exact,
          after.roots - before.roots,
          after.doubtfulTimes - before.doubtfulTimes,
          after.times - before.times,
          after.normals - before.normals);
    }
  }

  @ParameterizedTest
  @CsvFileSource(resources = "/rungs.csv", useHeadersInDisplayName = true)
  void asManyClimbAsBefore(
      String family,
      long doubtful,
      long exact,
      long roots,
      long doubtfulTimes,
      long times,
      long normals) {
    assertThat(Counts.of(new Draw(family.hashCode()), question(family)))
        .isEqualTo(new Counts(doubtful, exact, roots, doubtfulTimes, times, normals));
  }

  private static Consumer<Draw> question(String name) {
    if (name.startsWith("sphere_")) {
      return draw -> ask(SphereFamilies.next(name.substring(7), draw).numbers());
    }
    Family<Query> family =
        Stream.concat(Families.all().stream(), Brinks.all().stream())
            .filter(f -> f.name().equals(name))
            .findFirst()
            .orElseThrow();
    return draw -> ask(family.next(draw));
  }

  private static void ask(Query query) {
    double[] n = query.numbers();
    if (query instanceof SegmentQuery) {
      Circle circle = new Circle(n[4], n[5], n[6]);
      Line line = new Line(n[0], n[1], n[2], n[3]);
      new SweptCircle(circle, new Vec2(n[7], n[8])).cast(line, n[9]);
    } else if (query instanceof PairQuery) {
      Circle first = new Circle(n[0], n[1], n[2]);
      Circle second = new Circle(n[5], n[6], n[7]);
      new SweptCircle(first, new Vec2(n[3], n[4]))
          .cast(new SweptCircle(second, new Vec2(n[8], n[9])), n[10]);
      first.overlaps(second);
    } else if (query instanceof WallQuery) {
      new SweptCircle(n[0], n[1], n[2], n[3], n[4]).timeToBounds(n[5], n[6], n[7], n[8], n[9]);
    }
  }

  private static void ask(double[] n) {
    new SweptSphere(n[0], n[1], n[2], n[3], n[4], n[5], n[6])
        .timeToSphere(new SweptSphere(n[7], n[8], n[9], n[10], n[11], n[12], n[13]), n[14]);
    new SweptSphere(n[0], n[1], n[2], n[3], 0, 0, 0)
        .overlaps(new SweptSphere(n[7], n[8], n[9], n[10], 0, 0, 0));
  }

  /**
   * How often 600 frames look at a circle and a line together: the grid changes nothing but that.
   * Room for a fifth more, since which cells are the best is a matter of speed.
   */
  @ParameterizedTest
  @CsvSource({"base-1.csv, 13992", "fast-1.csv, 151930", "radii.csv, 13792"})
  void theGridLeavesFewPairsToLookAt(String scene, long pairs) {
    World world = new World(TestScenes.read(scene));
    long before = PrecisionCounter.PAIR_TESTS.count();
    for (int frame = 0; frame < 600; frame++) {
      world.step(1);
    }
    assertThat(PrecisionCounter.PAIR_TESTS.count() - before).isBetween(1L, pairs + pairs / 5);
  }
}
