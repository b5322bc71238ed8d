// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.ImpactLog;
import dev.carom.Internals;
import dev.carom.Outcome;
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

  /** As many impacts at one place as a circle makes that still bounces. */
  private static final int NEARLY = 24 * 64 - 1;

  private final ObstacleResponse response =
      new ObstacleResponse(
          ObstacleTable.of(Internals.data(Scene.builder().line(0, 0, 10, 10).build())),
          null,
          new Gravity(0, 0),
          (m, reach, now, into) -> {});
  private final ImpactRows rows = new ImpactRows(1);
  private final ImpactLog log = Internals.log(rows);
  private final MovingCircle m = new MovingCircle();

  /** On the upper side, in no time, after so many impacts. */
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
    assertThat(m.stuck).isEqualTo(8);
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
  void sharesOfRadiiOfAnySize() {
    assertThat(Coordinates.share(1, 3)).isEqualTo(0.25);
    assertThat(Coordinates.share(0x1p1023, 0x1p1023)).isEqualTo(0.5);
    assertThat(Coordinates.share(0x1p1022, 0x1.8p1023)).isEqualTo(0.25);
    assertThat(Coordinates.share(0, 0)).isZero();
  }

  @Test
  void theLargestSpeedIsOneYet() {
    m.start(0, 4, 6, 1, -Double.MAX_VALUE, Double.MAX_VALUE, 1);
    assertThat(ImpactRule.stopsBeyondRange(m)).isFalse();
    assertThat(m.vx).isEqualTo(-Double.MAX_VALUE);
    assertThat(m.vy).isEqualTo(Double.MAX_VALUE);
  }

  /** So long, or so short, that its length has no square. */
  @ParameterizedTest
  @ValueSource(doubles = {0x1p600, 0x1p-600})
  void theContactPointOfALineOfAnyLength(double unit) {
    SceneBuilder scene = Scene.builder().line(0, 0, 8 * unit, 0);
    World world = new World(scene.circle(2 * unit, 3 * unit, unit, 0, -unit).build());
    world.step(3);
    assertThat(world.impacts().time(0)).isEqualTo(2);
    assertThat(world.impacts().x(0)).isEqualTo(2 * unit);
    assertThat(world.impacts().y(0)).isZero();
  }
}
