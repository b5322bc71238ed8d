// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.advance;
import static dev.carom.stability.Play.among;
import static dev.carom.stability.Play.assertState;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Circle;
import dev.carom.Feature;
import dev.carom.Line;
import dev.carom.Run;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Lines that share an end: in a row, bent away, bent towards each other, and many at one point. */
class JointTest {

  private static final Line LEFT = new Line(0, 0, 10, 0);
  private static final Line RIGHT = new Line(10, 0, 20, 0);

  /**
   * The circle comes down exactly on the joint. Both lines are hit by their ends at once; the first
   * one turns the circle round, and then it does not approach the second.
   *
   * <pre>
   *            o
   *            v
   *   =========*=========
   * </pre>
   */
  @Test
  void twoLinesInARowAreHitOnceAtTheirJoint() {
    World world = world(among(LEFT, RIGHT).circle(10, 8, 2, 0, -3));
    List<Run.Row> hits = advance(world, 4);
    assertThat(hits).hasSize(1);
    assertThat(hits.get(0).time()).isEqualTo(2);
    assertThat(hits.get(0).obstacle()).isZero();
    assertThat(hits.get(0).feature()).isEqualTo(Feature.END);
    assertState(world, 0, 10, 8, 0, 3);
  }

  /** Overlap tests turn it round for each line that they find: twice is not at all. */
  @Test
  void aNaiveResponseToBothCancels() {
    Naive naive = new Naive(new Circle(10, 3, 2), new Vec2(0, -2), LEFT, RIGHT);
    naive.y = 1;
    for (Line line : naive.lines) {
      assertThat(Naive.distance(line, naive.x, naive.y)).isLessThan(naive.r);
      naive.vy = -naive.vy;
    }
    assertThat(naive.vy).as("goes on through the floor").isNegative();

    World world = world(among(LEFT, RIGHT).circle(10, 3, 2, 0, -2));
    assertThat(advance(world, 1)).hasSize(1);
    assertState(world, 0, 10, 3, 0, 2);
  }

  @ParameterizedTest
  @CsvSource({"9.999999,0", "10.000001,1", "5,0", "15,1"})
  void besideTheJointTheNearerLineIsHitOnItsSide(double x, int line) {
    World world = world(among(LEFT, RIGHT).circle(x, 8, 2, 0, -3));
    List<Run.Row> hits = advance(world, 4);
    assertThat(hits).hasSize(1);
    assertThat(hits.get(0).obstacle()).isEqualTo(line);
    assertThat(hits.get(0).feature()).isEqualTo(Feature.SIDE);
    assertState(world, 0, x, 8, 0, 3);
  }

  /** No ghost of the joint, which stops a circle that rounding or a slop let sink in. */
  @Test
  void aCircleSlidesOverAJoint() {
    for (double sunk : new double[] {1e-13, 1e-6}) {
      double t = Naive.pointTime(3 - 10, 2 - sunk, 2, new Vec2(1, 0));
      assertThat(t).as("meets the ghost of the joint").isLessThan(Naive.NEVER);
    }

    World world = world(among(LEFT, RIGHT).circle(3, 2, 2, 1, 0));
    assertThat(advance(world, 100)).isEmpty();
    assertState(world, 0, 103, 2, 1, 0);
  }

  /**
   * A roof: above its ridge the ends of both lines are met.
   *
   * <pre>
   *         o
   *         v
   *      _.=*=._
   *   .=         =.
   * </pre>
   */
  @Test
  void twoLinesBentAwayAreHitOnceAtTheirJoint() {
    World world =
        world(among(new Line(0, -4, 8, 0), new Line(8, 0, 16, -4)).circle(8, 8, 2, 0, -3));
    assertThat(advance(world, 4))
        .singleElement()
        .matches(hit -> hit.feature() == Feature.END && hit.time() == 2);
    assertState(world, 0, 8, 8, 0, 3);
  }

  /**
   * A right-angled valley: falling into the middle, the circle hits both sides at once and goes
   * back up as it came. One impact a frame would drop the second one, and the rest of the frame.
   *
   * <pre>
   *   \   o   /
   *    \  v  /
   *     \   /
   *      \ /
   * </pre>
   */
  @Test
  void twoLinesBentTowardsAreHitOneAfterTheOther() {
    Line down = new Line(-32, 32, 0, 0);
    Line up = new Line(0, 0, 32, 32);
    Naive naive = new Naive(new Circle(0, 16, 2), new Vec2(0, -1), down, up);
    naive.oneImpactPerFrame(32);
    assertThat(naive.y).as("has not come back").isLessThan(4);

    World world = world(among(down, up).circle(0, 16, 2, 0, -1));
    List<Run.Row> hits = advance(world, 32);
    assertThat(hits).extracting(Run.Row::obstacle).containsExactly(0, 1);
    double t = 16 - 2 * Math.sqrt(2);
    for (Run.Row hit : hits) {
      assertThat(hit.time()).isCloseTo(t, within(1e-14));
      assertThat(hit.feature()).isEqualTo(Feature.SIDE);
      assertThat(hit.speed()).isCloseTo(Math.sqrt(0.5), within(1e-15));
    }
    assertThat(world.vx(0)).isCloseTo(0, within(1e-15));
    assertThat(world.vy(0)).isCloseTo(1, within(1e-15));
    assertThat(world.y(0)).isCloseTo(16 + 32 - 2 * t, within(1e-13));
  }

  /** However many lines end in the point that is hit, it is hit once, and at once. */
  @ParameterizedTest
  @ValueSource(ints = {2, 3, 50, 10_000})
  void aFanOfLinesIsHitOnceAtItsPoint(int count) {
    Line[] fan = new Line[count];
    for (int i = 0; i < count; i++) {
      double angle = Math.PI * (1 + (i + 0.5) / count);
      fan[i] = new Line(0, 0, 50 * Math.cos(angle), 50 * Math.sin(angle));
    }
    int overlaps = 0;
    for (Line line : fan) {
      overlaps += Naive.distance(line, 0, 0.5) < 1 ? 1 : 0;
    }
    assertThat(overlaps).as("a naive circle is turned round by each").isEqualTo(count);

    World world = world(among(fan).circle(0, 9, 1, 0, -1));
    List<Run.Row> hits = advance(world, 16);
    assertThat(hits).hasSize(1);
    assertThat(hits.get(0).time()).isEqualTo(8);
    assertThat(hits.get(0).feature()).isEqualTo(Feature.START);
    assertState(world, 0, 0, 9, 0, 1);
  }

  /** Ten thousand lines that cross at one point, like the spokes of a wheel, from all sides. */
  @Test
  void tenThousandLinesThroughOnePointKeepTheEnergy() {
    int count = 10_000;
    Line[] spokes = new Line[count];
    for (int i = 0; i < count; i++) {
      double angle = Math.PI * i / count;
      double x = 50 * Math.cos(angle);
      double y = 50 * Math.sin(angle);
      spokes[i] = new Line(-x, -y, x, y);
    }
    World world = world(among(spokes).bounds(-200, -200, 200, 200).circle(-120, 3, 1, 5, 0.5));
    int impacts = 0;
    for (int frame = 1; frame <= 200; frame++) {
      impacts += advance(world, frame).size();
      assertThat(Math.hypot(world.x(0), world.y(0))).isGreaterThan(51 - 1e-3);
    }
    assertThat(impacts).isGreaterThan(2);
    assertThat(Play.speed(world, 0)).isCloseTo(Math.hypot(5, 0.5), within(1e-14));
  }
}
