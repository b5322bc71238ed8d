// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static dev.carom.Kind.CIRCLE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.ImpactLog;
import dev.carom.Internals;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Snapshot;
import dev.carom.SnapshotBytes;
import dev.carom.Timeline;
import dev.carom.Traits;
import dev.carom.Uncertainty;
import dev.carom.World;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.TraitValues;
import dev.carom.internal.state.WorldState;
import dev.carom.internal.util.KindNumber;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Worlds that have lived so long that all ids of a kind were given. */
class IdLimitTest {

  private static final int CIRCLES = 1_610_612_736;
  private static final int LINES = (1 << 28) - 4;
  private static final int PEGS = 1 << 28;
  private static final TraitValues PLAIN = new TraitValues(1, 1, 0, FilterBits.DEFAULT);

  /** A world of three circles, the last with the id before a given end of ids. */
  private static World old(boolean collide, int idLimit) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 100, 100).collide(collide);
    scene.circle(20, 50, 3, 4, 0).circle(50, 50, 3, 0, 0).circle(80, 50, 3, -4, 1);
    World world = new World(scene.build());
    WorldState s = Internals.state(world.snapshot());
    CircleRegistry registry = new CircleRegistry(new int[] {0, 7, idLimit - 1}, idLimit);
    world.restore(
        Internals.snapshot(
            new WorldState(
                s.now(), collide, s.obstacles(), registry, s.limits(), s.flights(), 0, 0, 0)));
    return world;
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void theLastIdOfACircleIsLikeOthers(boolean collide) {
    World world = old(collide, CIRCLES - 1);
    int last = world.addCircle(50, 20, 3, 0, 9, Traits.DEFAULT);
    assertThat(last).isEqualTo(CIRCLES - 1);
    world.step(10);
    assertThat(world.impacts().size()).isPositive();
    Snapshot snapshot = world.snapshot();
    assertThat(SnapshotBytes.copy(snapshot)).isEqualTo(snapshot);
    World other = new World(world.scene());
    other.restore(SnapshotBytes.copy(snapshot));
    assertThat(Run.rows(after(other))).isEqualTo(Run.rows(after(world)));
    world.remove(CIRCLE, last);
    assertThat(world.contains(CIRCLE, last)).isFalse();
    assertThat(world.ids(CIRCLE)).containsExactly(0, 7, CIRCLES - 2);
  }

  /** Paths are kept for the circles that are there: an array by ids would not fit in memory. */
  @Test
  void anUncertaintyOfLargeIdsTakesLittleMemory() {
    World world = old(false, CIRCLES - 1);
    Uncertainty uncertainty = world.uncertainty(0.1);
    int last = world.addCircle(50, 20, 3, 0, 9, Traits.DEFAULT);
    assertThat(uncertainty.bound(last)).isInfinite();
    assertThat(uncertainty.lostAt(last)).isZero();
    world.remove(CIRCLE, 7);
    uncertainty.restart(last);
    world.step(10);
    assertThat(world.impacts().size()).isPositive();
    for (int id : new int[] {0, CIRCLES - 2, last}) {
      assertThat(uncertainty.bound(id)).isPositive().isLessThan(1e-10);
    }
  }

  private static ImpactLog after(World world) {
    world.step(20);
    return world.impacts();
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void noMoreCirclesThanIdsAreAdded(boolean collide) {
    World world = old(collide, CIRCLES);
    world.remove(CIRCLE, 7);
    Snapshot before = world.snapshot();
    assertThatThrownBy(() -> world.addCircle(50, 20, 3, 0, 9, Traits.DEFAULT))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage(
            "circle 1610612736 cannot be added: all ids below 1610612736 were given, and none is"
                + " reused");
    assertThat(world.snapshot()).isEqualTo(before);
    assertThat(world.idLimit(CIRCLE)).isEqualTo(CIRCLES);
    world.step(5);
  }

  /** So many rows would take gigabytes: here they are only said to be there. */
  @Test
  void noMoreLinesAndPegsThanIdsAreAdded() {
    Scene scene = Scene.builder().line(1, 2, 3, 4).peg(5, 6, 7).build();
    CircleRegistry registry = new CircleRegistry(Internals.data(scene), 1);
    Engine engine =
        new IndependentEngine(
            Internals.data(scene), registry, EngineOptions.CHOSEN, new ImpactRows(1));
    Editor editor = new Editor(Internals.data(scene), engine, registry);
    ObstacleTable obstacles = engine.staticScene.obstacles;
    obstacles.lines.end = Codes.line(LINES);
    obstacles.ofKind(KindNumber.PEG).end = Codes.peg(PEGS);
    assertThatThrownBy(() -> editor.add(KindNumber.LINE, 1, 2, 3, 4, PLAIN, 0))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage(
            "line 268435452 cannot be added: all ids below 268435452 were given, and none is"
                + " reused");
    assertThatThrownBy(() -> editor.add(KindNumber.PEG, 1, 2, 3, 0, PLAIN, 0))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage(
            "peg 268435456 cannot be added: all ids below 268435456 were given, and none is"
                + " reused");
  }

  /** An id alone takes no memory. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aRecordingFollowsWhatIsThere(boolean collide) {
    World world = old(collide, CIRCLES - 10);
    Timeline past = world.record(100);
    int id = world.addCircle(50, 20, 3, 0, 9, Traits.DEFAULT);
    world.step(4);
    world.remove(CIRCLE, 0);
    world.step(4);
    assertThat(past.x(7, 0)).isEqualTo(50);
    assertThat(past.y(id, 0.5)).isEqualTo(24.5);
    assertThat(past.contains(CIRCLE, 0, 3.5)).isTrue();
    assertThat(past.contains(CIRCLE, 0, 4)).isFalse();
    assertThat(past.contains(CIRCLE, 3, 3)).isFalse();
    assertThat(past.contains(CIRCLE, CIRCLES - 20, 3)).isFalse();
  }
}
