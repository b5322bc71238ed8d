// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.exact.PrecisionCounter;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Ties with what turns, from scenes of small whole numbers: most are answered without algebraic
 * numbers, and those are not slow.
 */
@EnabledIfSystemProperty(named = "dev.carom.rungs", matches = "true")
class TurningTiesTest {
  private static final int FIRST = 0;
  private static final int RETURN = 1;
  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** A ball above an end, and one on the line with its centre, when a flipper starts to turn. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "-5.999999999999998 1.999999999999999 -5.999999999999999 -3.0000000000000027 0 -6 2 1"
            + " -1 0 0 -1 1 1 -0.2928932188134524 -0.7071067811865476 0 1",
        "-6.999999999999998 -4.999999999999999 -6.999999999999999 -6.999999999999999 0 -7 -5 1"
            + " 0 0 0 -1 -3 3 -0.1464466094067262 -0.3535533905932738 0 2",
        "3 0.9999999999999994 -3 1.0000000000000002 0 1 1 1"
            + " 0 0 0 -1 -1 1 -0.0732233047033631 0.1767766952966369 0 4",
        "-1 3 1.9999999999999996 9 0 0.5 6 1"
            + " 0 0 0 0 2 2 -0.003901166385335474 -0.06233736669261385 0 4"
      })
  void aTieAtTheStartIsDecidedBySumsWithoutRounding(String numbers) {
    decidedEarly(FIRST, 0, numbers);
  }

  /** The line comes to touch a ball near an end: the corner of its region is ulps away. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "-7 7 -10.973617425066752 6.541344836281255 0 -11 8 1 0 0 0 0"
            + " -7 7 -0.10818188209900148 -0.22386357168553422 0 4",
        "-5.936631942137537 -5.103170164181682 -2.9372786889111198 -5.040880017608523 0 -3 -4 1"
            + " 0 0 0 0 -1 -2 -0.00302997203510331 -0.041499781456702856 0 4",
        "8 -1 13.977440078262468 -1.5198173821464314 0 14 0 1 0 0 0 0"
            + " 8 -1 -0.07929177712661999 0.1701575855322229 0 4"
      })
  void aContactBesideACornerIsDecidedBySumsWithoutRounding(String numbers) {
    decidedEarly(FIRST, 0.25, numbers);
  }

  /** It comes over the ball, which has the projection 0 then; or it goes away. */
  @Test
  void aDiskAtRestThatTouchesThePivotIsHitWhenItComesBesideTheLine() {
    decidedEarly(
        FIRST,
        0.75,
        "0.3169750908485516 -8.924377271213771 6 -7 0 6 -6 1"
            + " 0 0 0 0 6 -7 -0.12378647285642475 -0.19923132107220645 0 3.75");
    decidedEarly(
        FIRST,
        NEVER,
        "5 3 8.165237808096817 7.356749891627296 0 5 4 1"
            + " 0 0 0 0 5 3 -0.1778917987489006 -0.10105148074695083 0 5.25");
  }

  /** The end at the pivot rests. It is passed at a distance of the radius, at no double. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "-4.000000000000002 7 -4 1 0 -3 4 1"
            + " 0 -1 0 -1 -4 1 -0.02537348916290441 0.12756114412169658 0 3",
        "6 -7 5 -12 0 3.3 -6 1 0.7 0 0 0 6 -7 -0.02537348916290441 0.12756114412169658 0 5",
        "5 -12 6 -7 0 6.5 3 0.5 0 -1 0 -0.3 6 -7 -0.02537348916290441 -0.12756114412169658 0 6"
      })
  void aGrazeOfThePivotIsNoContact(String numbers) {
    decidedEarly(FIRST, NEVER, numbers);
  }

  /** Its centre is on the line when it is hit, as at the start. */
  @Test
  void theSideThatADiskComesBackToIsTheOneThatItLeft() {
    String numbers =
        "-3.0000000000000013 -4 -1 -8 0 -2 -6 1 1.0606601717798214 0.530330085889911"
            + " 0 0 -1 -8 -0.0732233047033631 -0.1767766952966369 0 4";
    decidedEarly(RETURN, 2.1679434646041313, numbers);
    assertThat(TurningFalls.answer(RETURN, numbers(numbers))[1]).isEqualTo(Contact.LEFT);
  }

  /** A search asks a bit beyond the end of its window: here beyond 0. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "2.8598 -5.6949 4.4589 -10.8372 0 3.4623 -11 1 -7.2 -0.001 0 -1 0 1 0.01425 -0.2754 0"
            + " 4.9e-324",
        "-1.7031 -9.6987 -1.7031 -9.6987 2 1 -11 1 6.96 -0.018 0 -1 4 -4 0.0256 0.41262 0"
            + " 4.9e-324"
      })
  void aReturnInAWindowOfNoLengthIsDecidedByRoundedNumbers(String numbers) {
    decidedEarly(RETURN, NEVER, numbers);
  }

  private static void decidedEarly(int kind, double time, String numbers) {
    double[] n = numbers(numbers);
    long before = PrecisionCounter.EXACT_PARABOLAS.count();
    double[] said = TurningFalls.answer(kind, n);
    assertThat(PrecisionCounter.EXACT_PARABOLAS.count()).isEqualTo(before);
    assertThat(said[0]).isEqualTo(TurningFalls.exactTime(kind, n));
    if (time == NEVER) {
      assertThat(said[0]).isEqualTo(time);
    } else {
      assertThat(said[0]).isCloseTo(time, within(1e-12));
    }
    if (kind == FIRST && time < NEVER) {
      assertThat(said[1]).isEqualTo(TurningFalls.exactContact(TurningFalls.root(said[0], n), n));
    }
  }

  @Test
  void algebraicNumbersAreLookedForNoFurtherThanTheContact() {
    double[] n =
        numbers(
            "-5.999999999999998 1.999999999999999 -5.999999999999999 -3.0000000000000027 0 -6 2 1"
                + " -1 0 0 -1 1 1 -0.2928932188134524 -0.7071067811865476 0 1");
    long before = ExactBudget.ofThread().bits();
    TurningFalls.root(0, n);
    assertThat(ExactBudget.ofThread().impactsSince(before)).isLessThan(2_000); // 12,700 for ever
  }

  private static double[] numbers(String numbers) {
    return Arrays.stream(numbers.split(" ", -1)).mapToDouble(Double::parseDouble).toArray();
  }
}
