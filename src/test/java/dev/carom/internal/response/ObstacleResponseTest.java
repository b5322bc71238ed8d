// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.ImpactLog;
import dev.carom.Internals;
import dev.carom.Outcome;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Coordinates;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The result of impacts at one place, on a line that rises to the right and in wedges. */
class ObstacleResponseTest {

  /** As stuck as a circle is that still bounces. */
  private static final int NEARLY = StuckRule.LIMIT - StuckRule.ELASTIC;

  private final ObstacleResponse response =
      new ObstacleResponse(
          ObstacleTable.of(Internals.data(Scene.builder().line(0, 0, 10, 10).build())),
          new Gravity(0, 0),
          m -> new int[0]);
  private final ImpactRows rows = new ImpactRows(1);
  private final ImpactLog log = Internals.log(rows);
  private final MovingCircle m = new MovingCircle();

  /** On the upper side, in no time, after impacts of that weight. */
  private int hit(double vx, double vy, int stuck) {
    m.start(0, 4, 6, 1, vx, vy, 1);
    m.stuck = stuck;
    m.next = Codes.line(0);
    m.contact = Contact.LEFT;
    rows.clear();
    return response.resolve(m, rows);
  }

  @Test
  void anImpactCountsOnceAndBounces() {
    assertThat(hit(1, -1, 7)).isEqualTo(ObstacleResponse.NEW_FLIGHT);
    assertThat(m.stuck).isEqualTo(7 + StuckRule.ELASTIC);
    assertThat(m.vx).isEqualTo(-1);
    assertThat(m.vy).isOne();
    assertThat(log.outcome(0)).isEqualTo(Outcome.BOUNCED);
  }

  @Test
  void aStuckCircleDoesNotBounce() {
    assertThat(hit(1, 0.5, NEARLY)).isEqualTo(ObstacleResponse.NEW_FLIGHT);
    assertThat(m.vx).isEqualTo(0.5);
    assertThat(m.vy).isOne();
    assertThat(hit(1, 0.5, NEARLY + 1)).isEqualTo(ObstacleResponse.STUCK);
    assertThat(m.vx).isEqualTo(0.75);
    assertThat(m.vy).isEqualTo(0.75);
    assertThat(log.outcome(0)).isEqualTo(Outcome.JAMMED);
    assertThat(m.jam).isNull();
  }

  @Test
  void whatItApproachesByRoundingIsInertForIt() {
    assertThat(hit(1, 1 - 0x1p-50, StuckRule.LIMIT)).isEqualTo(ObstacleResponse.NEW_FLIGHT);
    assertThat(log.outcome(0)).isEqualTo(Outcome.JAMMED);
    assertThat(m.vx).isBetween(1 - 0x1p-49, 1.0);
    assertThat(m.vy).isEqualTo(m.vx);
    assertThat(m.jam.makesInert(Codes.line(0))).isTrue();
  }

  /** Two lines that meet below it in a narrow wedge; it hits one of them, then the other. */
  private static Scene wedge(double restitution) {
    SceneBuilder builder = Scene.builder().line(0, 0, 10, 20).restitution(restitution);
    return builder.line(0, 0, -10, 20).restitution(restitution).build();
  }

  private void hitInWedge(ObstacleResponse wedge, int line, int contact) {
    m.next = Codes.line(line);
    m.contact = contact;
    m.cleared = 0;
    rows.clear();
    wedge.resolve(m, rows);
  }

  /** The first line turns it to the left, the second to the right: it would never end. */
  @Test
  void withoutBounceItStopsWhenItIsTurnedBack() {
    ObstacleResponse wedge =
        new ObstacleResponse(
            ObstacleTable.of(Internals.data(wedge(0))), new Gravity(0, 0), m -> new int[0]);
    m.start(0, 0, 5, 1, 0, -1, 1);
    hitInWedge(wedge, 0, Contact.LEFT);
    assertThat(m.vy).isEqualTo(-0.8);
    assertThat(log.outcome(0)).isEqualTo(Outcome.BOUNCED);
    hitInWedge(wedge, 1, Contact.RIGHT);
    assertThat(m.vx).isZero();
    assertThat(m.vy).isZero();
    assertThat(log.outcome(0)).isEqualTo(Outcome.JAMMED);
  }

  @Test
  void itGoesOnIfItCameFromElsewhere() {
    ObstacleResponse wedge =
        new ObstacleResponse(
            ObstacleTable.of(Internals.data(wedge(0))), new Gravity(0, 0), m -> new int[0]);
    m.start(0, 0, 5, 1, 0, -1, 1);
    hitInWedge(wedge, 0, Contact.LEFT);
    m.next = Codes.line(1);
    m.contact = Contact.RIGHT;
    m.cleared = 0x1p-40;
    rows.clear();
    wedge.resolve(m, rows);
    assertThat(m.vy).isCloseTo(-0.48, within(1e-15));
    assertThat(log.outcome(0)).isEqualTo(Outcome.BOUNCED);
  }

  /** A wider wedge turns it twice the same way: it goes up on the other side. */
  @Test
  void whatTurnsItOnTheSameWayLetsItGoOn() {
    SceneBuilder setup = Scene.builder().line(0, 0, 20, 10).restitution(0);
    Scene wide = setup.line(0, 0, -20, 10).restitution(0).build();
    ObstacleResponse wedge =
        new ObstacleResponse(
            ObstacleTable.of(Internals.data(wide)), new Gravity(0, 0), m -> new int[0]);
    m.start(0, 0, 5, 1, 0, -1, 1);
    hitInWedge(wedge, 0, Contact.LEFT);
    hitInWedge(wedge, 1, Contact.RIGHT);
    assertThat(m.vx).isCloseTo(-0.24, within(1e-15));
    assertThat(m.vy).isCloseTo(0.12, within(1e-15));
    assertThat(log.outcome(0)).isEqualTo(Outcome.BOUNCED);
  }

  @Test
  void sharesOfRadiiOfAnySize() {
    assertThat(Coordinates.share(1, 3)).isEqualTo(0.25);
    assertThat(Coordinates.share(0x1p1023, 0x1p1023)).isEqualTo(0.5);
    assertThat(Coordinates.share(0x1p1022, 0x1.8p1023)).isEqualTo(0.25);
    assertThat(Coordinates.share(0, 0)).isZero();
  }

  /** On the upper side of a line of length 8, sliding to the right, stuck. */
  private void slide(ObstacleResponse response, double vx, double vy) {
    m.start(0, 4, 1, 1, vx, vy, 1);
    m.stuck = StuckRule.LIMIT;
    m.next = Codes.line(0);
    m.contact = Contact.LEFT;
    rows.clear();
    response.resolve(m, rows);
  }

  /** The approach is taken along a normal of length 1, whatever the line's is. */
  @Test
  void slidingIsToApproachByRoundingOfTheSpeedAtMost() {
    ObstacleResponse level =
        new ObstacleResponse(
            ObstacleTable.of(Internals.data(Scene.builder().line(0, 0, 8, 0).build())),
            new Gravity(0, 0),
            m -> new int[0]);
    slide(level, 0x1p48, -1);
    assertThat(m.jam.makesInert(Codes.line(0))).isTrue();
    slide(level, 0x1p48, -1.0001);
    assertThat(m.jam).isNull();
  }

  @Test
  void soItIsAlongAnUprightLine() {
    ObstacleResponse upright =
        new ObstacleResponse(
            ObstacleTable.of(Internals.data(Scene.builder().line(5, 5, 5, -3).build())),
            new Gravity(0, 0),
            m -> new int[0]);
    slide(upright, -1, 0x1p48);
    assertThat(m.jam.makesInert(Codes.line(0))).isTrue();
    slide(upright, -1.0001, 0x1p48);
    assertThat(m.jam).isNull();
  }

  @Test
  void theLargestSpeedIsOneYet() {
    m.start(0, 4, 6, 1, -Double.MAX_VALUE, Double.MAX_VALUE, 1);
    assertThat(StopRule.stopsBeyondRange(m)).isFalse();
    assertThat(m.vx).isEqualTo(-Double.MAX_VALUE);
    assertThat(m.vy).isEqualTo(Double.MAX_VALUE);
  }

  /** So long, or so short, that its length has no square. */
  @ParameterizedTest
  @ValueSource(doubles = {0x1p600, 0x1p-600})
  void theContactPointOfALineOfAnyLength(double unit) {
    SceneBuilder scene = Scene.builder().line(0, 0, 8 * unit, 0);
    World world = new World(scene.circle(2 * unit, 3 * unit, unit, 0, -unit).build());
    Run.step(world, 3);
    assertThat(world.impacts().time(0)).isEqualTo(2);
    assertThat(world.impacts().x(0)).isEqualTo(2 * unit);
    assertThat(world.impacts().y(0)).isZero();
  }
}
