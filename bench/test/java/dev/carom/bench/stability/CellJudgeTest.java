// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** A circle of radius 10 flies by 2 a frame in a box, and others do something like it. */
class CellJudgeTest {

  private static final int FRAMES = 9;

  private static final Scene SCENE =
      Scene.builder()
          .line(0, 0, 100, 0)
          .line(100, 0, 100, 100)
          .line(100, 100, 0, 100)
          .line(0, 100, 0, 0)
          .circle(60, 50, 10, 2, 0)
          .build();

  private static final Cell CELL =
      new Cell(SCENE, new BoxCourse(SCENE, 100, 100, FRAMES), (x, y) -> x > 100, false);

  /** Where a fake has its circle at the end of a frame, and how fast. */
  private record Fake(DoubleUnaryOperator place, double speed) implements Contender.Starter {

    @Override
    public Method start(Scene scene) {
      return new Method() {
        private int frame;

        @Override
        public void frame() {
          frame++;
        }

        @Override
        public int impacts() {
          return 0;
        }

        @Override
        public int wallImpacts() {
          return 0;
        }

        @Override
        public int squareRoots() {
          return 0;
        }

        @Override
        public double x(int circle) {
          return place.applyAsDouble(frame);
        }

        @Override
        public double y(int circle) {
          return 50;
        }

        @Override
        public double vx(int circle) {
          return speed;
        }

        @Override
        public double vy(int circle) {
          return 0;
        }

        @Override
        public long pairTests() {
          return 0;
        }
      };
    }
  }

  private static CellOutcome judged(DoubleUnaryOperator place, double speed) {
    return CellJudge.of(new Contender("fake", "fake", "", new Fake(place, speed)), CELL).outcome();
  }

  private static double truth(double frame) {
    return 60 + 2 * frame;
  }

  @Test
  void theWorstFrameCounts() {
    assertThat(judged(CellJudgeTest::truth, 2)).isEqualTo(CellOutcome.RIGHT);
    assertThat(judged(t -> truth(t) + 0.0099, 2)).isEqualTo(CellOutcome.RIGHT);
    assertThat(judged(t -> truth(t) + (t == 3 ? 0.0101 : 0), 2)).isEqualTo(CellOutcome.DRIFTED);
    assertThat(judged(t -> truth(t) - (t == 3 ? 9.99 : 0), 2)).isEqualTo(CellOutcome.DRIFTED);
    assertThat(judged(t -> truth(t) - (t == 3 ? 10.01 : 0), 2)).isEqualTo(CellOutcome.FAR_OFF);
  }

  /** 10 units are a radius; whose speed is wrong, or who is outside, is within no distance. */
  @Test
  void howFarOffItWasIsToldForAnyLimit() {
    Contender off =
        new Contender("fake", "fake", "", new Fake(t -> truth(t) + (t == 3 ? 0.5 : 0), 2));
    assertThat(CellJudge.of(off, CELL).isWithin(0.051)).isTrue();
    assertThat(CellJudge.of(off, CELL).isWithin(0.049)).isFalse();
    Contender slow = new Contender("fake", "fake", "", new Fake(CellJudgeTest::truth, 1));
    assertThat(CellJudge.of(slow, CELL).isWithin(100)).isFalse();
  }

  @Test
  void speedCountsAtTheEndWhateverItsDirection() {
    assertThat(judged(CellJudgeTest::truth, -2)).isEqualTo(CellOutcome.RIGHT);
    assertThat(judged(CellJudgeTest::truth, 1.981)).isEqualTo(CellOutcome.RIGHT);
    assertThat(judged(CellJudgeTest::truth, 1.979)).isEqualTo(CellOutcome.LOST_SPEED);
    assertThat(judged(t -> truth(t) - 20, 0)).isEqualTo(CellOutcome.LOST_SPEED);
    assertThat(judged(CellJudgeTest::truth, Double.NaN)).isEqualTo(CellOutcome.LOST_SPEED);
  }

  @Test
  void whoIsOutsideOrNowhereHasEscaped() {
    assertThat(judged(t -> t == 4 ? 100.5 : truth(t), 2)).isEqualTo(CellOutcome.ESCAPED);
    assertThat(judged(t -> t == 4 ? Double.NaN : truth(t), 0)).isEqualTo(CellOutcome.ESCAPED);
    assertThat(judged(t -> Double.NEGATIVE_INFINITY, 2)).isEqualTo(CellOutcome.ESCAPED);
  }

  @Test
  void whoRefusesOrFailsHasNoAnswer() {
    Contender refuses =
        new Contender(
            "no",
            "no",
            "",
            scene -> {
              throw new UnsupportedOperationException("not this one");
            });
    assertThat(CellJudge.of(refuses, CELL).outcome()).isEqualTo(CellOutcome.NO_ANSWER);
    DoubleUnaryOperator endless =
        t -> {
          throw new IllegalStateException("circle 0 makes impacts without end");
        };
    assertThat(judged(endless, 2)).isEqualTo(CellOutcome.NO_ANSWER);
  }

  @Test
  void whereRoundingGrowsTooFarIsALimit() {
    assertThat(CELL.limit()).isEqualTo(CellLimit.NONE);
    assertThat(new Cell(SCENE, CELL.truth(), Fence.NONE, true).limit())
        .isEqualTo(CellLimit.PILE_UP);
    assertThat(new Cell(SCENE, null, Fence.NONE, false).limit()).isEqualTo(CellLimit.PILE_UP);
    // 4 x 2^-53 x 1e14 = 0.044: more than a thousandth of the radius, 0.01.
    Scene far = Scene.builder().circle(60, 50, 10, 1e13, 0).build();
    BoxCourse course = new BoxCourse(far, 100, 100, FRAMES);
    assertThat(new Cell(far, course, Fence.NONE, false).limit()).isEqualTo(CellLimit.DOUBLES);
  }
}
