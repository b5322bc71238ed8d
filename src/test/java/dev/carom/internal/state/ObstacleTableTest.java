// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.response.ScaledVectors;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.util.KindNumber;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ObstacleTableTest {

  private static ObstacleTable obstacles() {
    SceneBuilder setup = Scene.builder().bounds(0, 0, 9, 9).line(1, 2, 3, 4).line(2, 3, 4, 5);
    Scene scene = setup.peg(5, 6, 1).peg(6, 7, 1).build();
    return ObstacleTable.of(Internals.data(scene));
  }

  @Test
  void theyEqualWhatIsTheSameInAllWays() {
    assertThat(obstacles()).isEqualTo(obstacles()).hasSameHashCodeAs(obstacles());
    assertThat(obstacles().copy()).isEqualTo(obstacles());
    int line = Codes.line(1);
    int peg = Codes.peg(1);
    List<Consumer<ObstacleTable>> changes =
        List.of(
            o -> o.move(line, new double[] {2, 3, 4, 6}, 0),
            o -> o.move(peg, new double[] {6, 7, 2}, 0),
            o -> o.setVelocity(line, 1, 0, 0),
            o -> o.setVelocity(peg, 0, 1, 0),
            o -> o.setRestitution(line, 0.5),
            o -> o.setRestitution(peg, 0.5),
            o -> o.setRestitution(Codes.LEFT, 0.5),
            o -> o.setTraits(line, ContactFlags.with(0, ContactFlags.HALT)),
            o -> o.setTraits(peg, ContactFlags.with(0, ContactFlags.HALT)),
            o -> o.setTraits(Codes.LEFT, ContactFlags.with(0, ContactFlags.HALT)),
            o -> o.add(KindNumber.LINE, 1, 1, 2, 2),
            o -> o.add(KindNumber.PEG, 1, 1, 2),
            o -> o.remove(line),
            o -> o.remove(peg));
    for (Consumer<ObstacleTable> change : changes) {
      ObstacleTable changed = obstacles();
      change.accept(changed);
      assertThat(changed).isNotEqualTo(obstacles());
    }
    assertThat(obstacles()).isNotEqualTo("obstacles");
  }

  private static int[] there(ObstacleTable obstacles, int from, int end) {
    return IntStream.range(from, end).filter(code -> !obstacles.isGone(code)).toArray();
  }

  private static void assertPresent(ObstacleTable o) {
    assertPresent(o, o.lines.present(), there(o, Codes.line(0), o.lines.end));
    assertPresent(
        o,
        o.ofKind(KindNumber.PEG).present(),
        there(o, Codes.peg(0), o.ofKind(KindNumber.PEG).end));
    assertThat(o.size())
        .isEqualTo(o.lines.present().count() + o.ofKind(KindNumber.PEG).present().count());
  }

  private static void assertPresent(ObstacleTable o, LiveCodes present, int... there) {
    assertThat(present.stream(o::isGone).toArray()).isEqualTo(there);
    assertThat(present.count()).isEqualTo(there.length);
    assertThat(present.size()).isLessThanOrEqualTo(2 * there.length);
  }

  private static void edit(ObstacleTable o, Random random) {
    boolean line = random.nextBoolean();
    LiveCodes present = line ? o.lines.present() : o.ofKind(KindNumber.PEG).present();
    if (present.count() > 0 && random.nextInt(9) < 5) {
      int[] there = present.stream(o::isGone).toArray();
      o.remove(there[random.nextInt(there.length)]);
    } else if (line) {
      o.add(KindNumber.LINE, 1, 2, 3, 4);
    } else {
      o.add(KindNumber.PEG, 1, 2, 3);
    }
  }

  /** The list of live obstacles does not grow with the obstacles that were ever there. */
  @Test
  void whatIsGoneIsNotAmongWhatIsThere() {
    ObstacleTable obstacles = obstacles();
    ObstacleTable saved = obstacles.copy();
    Random random = new Random(1);
    for (int i = 0; i < 2000; i++) {
      edit(obstacles, random);
      assertPresent(obstacles);
      assertPresent(saved);
      if (random.nextInt(40) == 0) {
        ObstacleTable other = saved;
        saved = obstacles.copy();
        obstacles.set(other);
      }
    }
    assertThat(obstacles.lines.end).isGreaterThan(200);
    assertThat(obstacles.size()).isLessThan(100);
  }

  /** The second product is rounded by 2^-60, and the first takes away all but that. */
  @Test
  void sumsOfProductsKeepWhatRoundingLeaves() {
    double x = 1 + 0x1p-30;
    assertThat(ScaledVectors.dot(-(1 + 0x1p-29), x, 1, x)).isEqualTo(0x1p-60);
    assertThat(ScaledVectors.dot(3, 5, 7, -2)).isEqualTo(11);
  }

  /** Both ends of a line count; of a peg, its centre. */
  @Test
  void theExtentIsTheLargestCoordinate() {
    assertThat(ObstacleTable.of(Internals.data(Scene.builder().line(-9, 2, 3, 4).build())).extent())
        .isEqualTo(9);
    assertThat(ObstacleTable.of(Internals.data(Scene.builder().line(1, 2, 3, -8).build())).extent())
        .isEqualTo(8);
    assertThat(ObstacleTable.of(Internals.data(Scene.builder().peg(1, -2, 50).build())).extent())
        .isEqualTo(2);
    assertThat(
            ObstacleTable.of(Internals.data(Scene.builder().bounds(0, 0, 9, 9).build())).extent())
        .isZero();
  }

  @Test
  void traitsAreCountedAsTheyComeAndGo() {
    ObstacleTable all = obstacles();
    assertThat(all.areSpecial()).isFalse();
    assertThat(all.haveSensors()).isFalse();
    for (int code : new int[] {Codes.line(0), Codes.peg(0)}) {
      all.setTraits(code, ContactFlags.with(0, ContactFlags.SENSOR));
      assertThat(all.areSpecial()).isTrue();
      assertThat(all.haveSensors()).isTrue();
      all.setTraits(code, 0);
      assertThat(all.areSpecial()).isFalse();
      assertThat(all.haveSensors()).isFalse();
      all.setTraits(code, ContactFlags.with(0, ContactFlags.SENSOR));
      all.remove(code);
      assertThat(all.areSpecial()).isFalse();
      assertThat(all.haveSensors()).isFalse();
    }
  }

  /** A windmill blade a quarter turn on its way: its velocity is none, its rate is. */
  @Test
  void whatTurnsIsNotAtRest() {
    ObstacleTable all = obstacles();
    int code = Codes.line(0);
    double[] there = {1, 2, 1, 5};
    double[] motion = new double[ObstacleMotions.SIZE];
    ObstacleMotions.setTurn(motion, 1, 2, Math.PI / 2, 0, 2);
    all.moveTo(code, there, motion);
    assertThat(all.turns(code)).isTrue();
    assertThat(all.isAtRest(code)).isFalse();
    assertThat(all.ux(code)).isZero();
    assertThat(all.pivotX(code)).isEqualTo(1);
    assertThat(all.pivotY(code)).isEqualTo(2);
    assertThat(all.goesTo(code, 1, 2, 2)).isFalse(); // that is straight
    double[] row = all.rowAt(code, 0.5, 0.5);
    assertThat(row[LineShape.BX]).isCloseTo(1 + 3 * Math.sqrt(0.5), within(1e-15));
    assertThat(row[LineShape.BY]).isCloseTo(2 + 3 * Math.sqrt(0.5), within(1e-15));
    assertThat(all.rate(code, 1, 0)).isCloseTo(2 * Math.tan(Math.PI / 8), within(1e-15));
    assertThat(all.rate(code, 2, 0)).isEqualTo(2 * all.turnY(code, 2, 0));
    all.beginQuestion(0.5);
    assertThat(all.rowAt(code, 0.25, 0.25)).isEqualTo(row);
    all.endQuestion();
    all.setVelocity(code, 0, 0, 2);
    assertThat(all.turns(code)).isFalse();
    assertThat(all.isAtRest(code)).isTrue();
    assertThat(all.rowAt(code, 3, 0)).startsWith(there);
  }
}
