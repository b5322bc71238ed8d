// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.PrecisionCounter;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Scenes of which the numbers are small and round, as level editors give them, ask many questions
 * that lie exactly on a border. Sums of doubles without rounding decide these; none takes algebraic
 * numbers, which are a thousand times slower. The quick filter answers nearly all of the others, so
 * that an impact costs hardly more than in a scene without such numbers.
 */
@EnabledIfSystemProperty(named = "dev.carom.rungs", matches = "true")
class TiesTest {
  private static final int SCENES = 250;

  /** At most one question in so many impacts may go to the certified search. */
  private static final int IMPACTS_PER_SEARCH = 8;

  /** Where a ball is dropped: above the point (x, y). */
  private enum Place {
    END {
      @Override
      void add(SceneBuilder b, int x, int y, int u, int v, int other) {
        b.line(x, y, x + u, y + v);
      }
    },
    JOINT {
      @Override
      void add(SceneBuilder b, int x, int y, int u, int v, int other) {
        b.line(x, y, x + u, y + v).line(x, y, x - u, y + other);
      }
    },
    RIGHT_ANGLE {
      @Override
      void add(SceneBuilder b, int x, int y, int u, int v, int other) {
        b.line(x, y, x + u, y + v).line(x, y, x - v, y + u);
      }
    },
    SYMMETRIC_SLOPES {
      @Override
      void add(SceneBuilder b, int x, int y, int u, int v, int other) {
        b.line(x, y, x + u, y + v).line(x, y, x - u, y + v);
      }
    };

    abstract void add(SceneBuilder b, int x, int y, int u, int v, int other);
  }

  /** Decisions and answers that took algebraic numbers on the way to a time. */
  private static long exactAnswers(Scene scene, double time) {
    long before = exactAnswers();
    new World(scene).advanceTo(time);
    return exactAnswers() - before;
  }

  private static long exactAnswers() {
    return PrecisionCounter.EXACT_DECISIONS.count() + PrecisionCounter.EXACT_PARABOLAS.count();
  }

  @Test
  void aBallBouncesOnTheEndOfALine() {
    Scene scene =
        Scene.builder().gravity(0, -10).line(0, 12, 4, 12).circle(4, 14, .5, 0, 0).build();
    assertThat(exactAnswers(scene, 200)).isZero();
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "1, 2", "1, 3", "2, 1", "3, 4"})
  void aBallBouncesInASymmetricWedge(double rise, double run) {
    double height = 700.1 * rise / run;
    Scene scene =
        Scene.builder()
            .gravity(0, -1)
            .line(0, 0, 700.1, height)
            .line(0, 0, -700.1, height)
            .circle(0.1, 4.3, 0.01, 0.3, 0.2)
            .build();
    assertThat(exactAnswers(scene, 200_000)).isZero();
  }

  @ParameterizedTest
  @EnumSource
  void aBallFallsOnSmallIntegers(Place place) {
    Random random = new Random(place.ordinal());
    long searches = PrecisionCounter.SEARCHED_PARABOLAS.count();
    long impacts = 0;
    for (int i = 0; i < SCENES; i++) {
      int x = random.nextInt(21) - 10;
      int y = random.nextInt(21) - 10;
      SceneBuilder b = Scene.builder().gravity(0, -1 - random.nextInt(10));
      place.add(b, x, y, 1 + random.nextInt(10), random.nextInt(11) - 5, random.nextInt(11) - 5);
      int speed = random.nextInt(3) == 0 ? random.nextInt(5) - 2 : 0;
      int height = y + 14 + random.nextInt(5); // clear of all lines
      Scene scene = b.circle(x, height, 1 + random.nextInt(2), speed, 0).build();
      long before = exactAnswers();
      World world = new World(scene);
      world.advanceTo(50);
      impacts += world.impacts().size();
      assertThat(exactAnswers() - before).as("scene %d", i).isZero();
    }
    searches = PrecisionCounter.SEARCHED_PARABOLAS.count() - searches;
    assertThat(searches * IMPACTS_PER_SEARCH).isLessThan(impacts);
  }
}
