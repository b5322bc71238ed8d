// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The oracle against two others: the committed cases, which another program made, and a second
 * method of its own. {@code -Dcarom.oracle.queries=10000} asks more of each family.
 */
class OracleTest {
  private static final MathContext DIGITS = new MathContext(100);

  static Stream<String> files() {
    return CaseFile.names().stream();
  }

  static Stream<Family<Query>> families() {
    return Families.all().stream();
  }

  @ParameterizedTest
  @MethodSource("files")
  void answersTheCommittedCases(String name) {
    List<CaseFile> cases = CaseFile.read(name);
    assertEquals(12, cases.size());
    for (CaseFile expected : cases) {
      Contact truth = expected.query().truth();
      assertEquals(expected.part(), truth.part(), expected.toString());
      if (truth.hit()) {
        assertEquals(expected.time(), truth.time(), expected.toString());
        BigDecimal digits = truth.moment().digits().toBigDecimal(DIGITS);
        BigDecimal error = digits.subtract(expected.digits()).abs();
        BigDecimal bound = expected.digits().movePointLeft(33);
        assertTrue(error.compareTo(bound) <= 0, expected.toString());
        assertTrue(truth.normalError(expected.nx(), expected.ny()) <= 1e-15, expected.toString());
      }
    }
  }

  /** BigInteger.bitLength is 3 for -8 and 4 for 8: once this made a tie of two surds a win. */
  @Test
  void comparesNegativePowersOfTwo() {
    assertEquals(0, new Surd(Dyadic.of(-8), Dyadic.of(2), Dyadic.of(16)).sign());
    assertEquals(0, Dyadic.of(-8).compareTo(Dyadic.of(-1).shift(3)));
    assertEquals(-1, new Surd(Dyadic.of(-8), Dyadic.of(2), Dyadic.of(15)).sign());
  }

  @Test
  void roundsToNearestAndTiesToEven() {
    Dyadic half = Dyadic.of(Math.ulp(1.0)).shift(-1);
    assertEquals(1.0, exactly(Dyadic.ONE.plus(half)).nearest());
    double odd = Math.nextUp(1.0);
    assertEquals(Math.nextUp(odd), exactly(Dyadic.of(odd).plus(half)).nearest());
    assertEquals(0.0, exactly(Dyadic.of(Double.MIN_VALUE).shift(-1)).nearest());
    Dyadic limit = Dyadic.powerOfTwo(1024).minus(Dyadic.powerOfTwo(970));
    assertEquals(Double.POSITIVE_INFINITY, exactly(limit).nearest());
    assertEquals(Double.MAX_VALUE, exactly(limit.minus(half)).nearest());
  }

  @Test
  void measuresInUlpsOfTheTruth() {
    Moment justAboveOne = exactly(Dyadic.ONE.plus(Dyadic.powerOfTwo(-100)));
    assertEquals(-0x1p-48, justAboveOne.errorInUlps(1.0));
    assertEquals(1 - 0x1p-48, justAboveOne.errorInUlps(Math.nextUp(1.0)));
    Moment one = exactly(Dyadic.ONE);
    assertEquals(-0.5, one.errorInUlps(Math.nextDown(1.0)));
    assertEquals(1.0, one.errorInUlps(Math.nextUp(1.0)));
  }

  /** Without this a judge that lets everything pass would go unnoticed. */
  @Test
  void findsTheErrorsOfTheTextbook() {
    Textbook textbook = new Textbook();
    Judge<Query> judge = new Judge<>(query -> query.ask(textbook));
    for (String name : List.of("seg_fast", "seg_near_tie_corner", "seg_voronoi_edge")) {
      assertTrue(total(judge, name).wrongDecisions() > 0, name);
    }
    for (String name : List.of("seg_shallow", "circ_size_ratio", "wall_far")) {
      assertTrue(total(judge, name).beyondOneUlp() > 0, name);
    }
  }

  private static Tally total(Judge<Query> judge, String name) {
    return families()
        .filter(family -> family.name().equals(name))
        .map(family -> judge.judge(family, 1, 1000))
        .findFirst()
        .orElseThrow();
  }

  private static Moment exactly(Dyadic time) {
    return new Moment(Surd.of(time), Dyadic.ONE);
  }
}
