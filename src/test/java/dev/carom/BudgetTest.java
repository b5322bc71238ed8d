// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.query.TracedPath;
import dev.carom.internal.query.Tracer;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Where exactly an unfinished step, or trace, ends: impacts counted by hand, and exact work. */
class BudgetTest {

  /** A tenth of the usual budget, in impacts: of a call, and of each circle besides. */
  private static final int MOST = 200_000;

  private static final int EACH = 100;

  /** A cell holds the whole room: then every event is an impact. */
  private static final EngineOptions ONE_CELL = new EngineOptions(true, 0, 1000, 1);

  /**
   * They turn each other round at a half, 2.5 and so on, and a unit of time later each is turned
   * round by its wall: three impacts in two units.
   */
  @Test
  void twoThatCollideMayHaveSoManyEvents() {
    SceneBuilder row = Scene.builder().bounds(0, 0, 12, 10);
    row.circle(3, 5, 1, 4, 0).circle(9, 5, 1, -4, 0);
    World world = new World(row.build(), ONE_CELL);
    world.advanceTo(0.5);
    int events = MOST + 2 * EACH;
    assertThat(world.advanceTo(2e6, events)).isFalse();
    assertThat(world.impacts().size()).isEqualTo(events);
    assertThat(world.now())
        .as("of two at a time, one is left")
        .isEqualTo((events - 1) / 3 * 2 + 1.5);
    world.advanceTo(world.now());
    assertThat(world.impacts().size()).isOne();
    world.advanceTo(world.now() + 2);
    assertThat(world.impacts().size()).isEqualTo(3);
  }

  /** From wall to wall in a unit of time; the others rest, and take nothing from it. */
  @ParameterizedTest
  @ValueSource(ints = {1, 50})
  void ofThoseThatIgnoreEachOtherAllMayMakeSoManyImpacts(int circles) {
    SceneBuilder scene = Scene.builder().collide(false).bounds(0, 0, 10, 10).circle(5, 5, 1, 8, 0);
    for (int i = 1; i < circles; i++) {
      scene.circle(5, 5, 1, 0, 0);
    }
    World world = new World(scene.build());
    int most = MOST;
    long work = Run.work(world, EACH);
    world.advanceTo(most - 0.5, work);
    assertThat(world.impacts().size()).isEqualTo(most);
    assertThat(world.advanceTo(2 * most + 0.5, work)).as("one more").isFalse();
    assertThat(world.impacts().size()).isEqualTo(most);
    assertThat(world.now()).isEqualTo(2 * most - 0.5);
  }

  /** A circle that spends much leaves the others their thousand impacts each. */
  @Test
  void eachMayMakeAThousandImpactsBesides() {
    SceneBuilder scene =
        Scene.builder().collide(false).bounds(0, 0, 10, 10).circle(5, 5, 1, 0x1p11, 0);
    World world = new World(scene.circle(5, 5, 1, 8, 0).circle(5, 5, 1, 9, 0).build());
    world.advanceTo(999);
    world.setVelocity(0, 0x1p14, 0);
    assertThat(world.advanceTo(1998, Run.work(world, 1_000)))
        .as("it would make 2,045,952")
        .isFalse();
    int[] impacts = new int[3];
    for (int i = 0; i < world.impacts().size(); i++) {
      impacts[world.impacts().circle(i)]++;
    }
    assertThat(impacts[0]).isGreaterThan(1_800_000);
    assertThat(impacts[1]).isBetween(880, 890);
    assertThat(impacts[2]).isEqualTo(1_000);
  }

  // Exact work.

  private static final double UNIT = 0x1p900;

  /**
   * Each time the circle leaves the right wall, its next impact is within 5e-324 of the middle of
   * two doubles: only numbers of thousands of bits tell which is nearer.
   */
  private static final Bounds NEAR_TIES =
      new Bounds(Double.MIN_VALUE, -9 * UNIT, (9 + 0x1p-49) * UNIT, 9 * UNIT);

  private static final Circle LEAVING = new Circle(8 * UNIT, 0, (1 + 0x1p-51) * UNIT);

  private static Scene nearTies(boolean collide) {
    Bounds b = NEAR_TIES;
    Circle c = LEAVING;
    SceneBuilder scene = Scene.builder().bounds(b.xmin(), b.ymin(), b.xmax(), b.ymax());
    scene.collide(collide).circle(c.x(), c.y(), c.radius(), -UNIT, 0);
    for (int i = 1; i < (collide ? 2 : 401); i++) {
      scene.circle(5 * UNIT, collide ? 8 * UNIT : 0, UNIT, 0, 0);
    }
    return scene.build();
  }

  private static long bits() {
    return ExactBudget.ofThread().bits();
  }

  private static long workSince(long before) {
    return ExactBudget.ofThread().impactsSince(before);
  }

  /** One search makes no more than 100 impacts of work. */
  @Test
  void exactWorkAndImpactsOfOneCallSpendItsBudgetTogether() {
    World world = new World(nearTies(true), ONE_CELL);
    long before = bits();
    assertThat(world.advanceTo(1e9, MOST + EACH)).isFalse();
    long work = workSince(before);
    assertThat(work).isGreaterThan(10_000);
    assertThat(world.impacts().size() + work).isBetween((long) MOST + EACH, MOST + EACH + 100L);
  }

  /** The same, but all is done twice: for where the first circle spends its own, nobody knows. */
  @Test
  void exactWorkAndImpactsOfOneCircleSpendItsBudgetTogether() {
    World world = new World(nearTies(false));
    long before = bits();
    assertThat(world.advanceTo(1e9, Run.work(world, 5))).isFalse();
    long work = workSince(before) / 2;
    assertThat(work).isGreaterThan(5_000);
    assertThat(world.impacts().size() + work).isBetween(10_000L, 10_100L);
  }

  private static TracedPath trace(int impacts, int most) {
    ObstacleTable obstacles = ObstacleTable.of(nearTies(true).data);
    Tracer tracer = new Tracer(new ObstacleIndex(obstacles));
    MovingCircle body = new SweptCircle(LEAVING, new Vec2(-UNIT, 0)).load(new MovingCircle(), 1);
    return tracer.trace(body, new Gravity(0, 0), null, null, 1e3, impacts, most);
  }

  /** The work to find the impact that comes after so many. */
  private static long workAfter(int impacts) {
    long before = bits();
    assertThat(trace(impacts + 1, Integer.MAX_VALUE).complete()).isTrue();
    return workSince(before);
  }

  /** But one impact is always made; and what was done in this thread before does not count. */
  @Test
  void exactWorkAndImpactsOfATraceSpendItsBudgetTogether() {
    assertThat(workAfter(0)).isGreaterThan(2);
    for (int most = 1; most < 40; most++) {
      int impacts = 1;
      while (impacts + workAfter(impacts) < most) {
        impacts++;
      }
      ExactBudget.add(1_000 * most);
      TracedPath trace = trace(1_000_000, most);
      assertThat(trace.impacts().size()).as("of %s", most).isEqualTo(impacts);
      assertThat(trace.complete()).isFalse();
    }
  }

  /**
   * A circle slides up from lines by less than doubles can tell, and hits one before: to know that
   * takes more work than a call may do, and the impact is made all the same.
   */
  @Test
  void aCallMakesAnImpactWhateverItTakesToFindIt() {
    SceneBuilder scene = Scene.builder().collide(false);
    for (int i = 0; i < 1200; i++) {
      scene.line(40 * UNIT, 0, 60 * UNIT, 0);
    }
    scene.line(30 * UNIT, 0, 30 * UNIT, 9 * UNIT);
    for (int i = 0; i < 401; i++) {
      scene.circle(20 * UNIT, 1.5 * UNIT, 1.5 * UNIT, 0, 0);
    }
    World world = new World(scene.build(), EngineOptions.EACH);
    world.setVelocity(0, 16 * UNIT, Double.MIN_VALUE);
    long before = bits();
    world.step(1e9);
    assertThat(workSince(before)).isGreaterThan(10_000);
    assertThat(world.impacts().size()).isOne();
  }

  /** A flight that meets more sensors than a call may report: it goes on, and time with it. */
  @Test
  void aFlightAmongVeryManySensorsGoesOnFromCallToCall() {
    SceneBuilder scene = Scene.builder().collide(false);
    for (int i = 0; i < 400; i++) {
      scene.circle(0, i == 0 ? 0 : 100 + 10 * i, 1, i == 0 ? 1 : 0, 0);
    }
    for (int i = 0; i < 11_000; i++) {
      scene.peg(10 + i * 0.5, 0, 0.1).response(Response.SENSOR);
    }
    World world = new World(scene.build());
    world.advanceTo(5);
    assertThat(world.advanceTo(8000, Run.work(world, 5))).isFalse();
    assertThat(world.impacts().size()).isEqualTo(10_000);
    assertThat(world.now()).isEqualTo(world.impacts().time(9_999)).isBetween(5_000.0, 5_010.0);
    world.advanceTo(8000);
    assertThat(world.impacts().size()).isEqualTo(1_000);
    assertThat(world.now()).isEqualTo(8000);
  }

  /**
   * All at the time that is asked for: what is left is told by the next call, which goes nowhere.
   */
  @Test
  void moreSensorsAtOneTimeThanACallMayReportLeaveItUnfinished() {
    SceneBuilder scene = Scene.builder().collide(false);
    for (int i = 0; i < 400; i++) {
      scene.circle(0, 100 * i, 1, i == 0 ? 1 : 0, 0);
    }
    for (int i = 0; i < 2_200; i++) {
      scene.line(10, -5, 10, 5).response(Response.SENSOR);
    }
    World world = new World(scene.build());
    assertThat(world.advanceTo(9, Run.work(world, 1))).isFalse();
    assertThat(world.impacts().size()).isEqualTo(2_000);
    assertThat(world.now()).isEqualTo(9);
    world.advanceTo(9);
    assertThat(world.impacts().size()).isEqualTo(200);
  }
}
