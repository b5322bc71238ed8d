// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.duel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.bench.reference.Reference;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class DuelTest {

  /** Engines at their defaults fail in all of them. */
  private static final Set<Rival> ENGINES = EnumSet.of(Rival.BOX2D, Rival.DYN4J, Rival.JBOX2D);

  /** The other rivals that fail. */
  private static final Map<Preset, Set<Rival>> OTHERS = new EnumMap<>(Preset.class);

  static {
    Set<Rival> both = EnumSet.of(Rival.PUBLISHED, Rival.SUBSTEPS);
    OTHERS.put(Preset.FAST, both);
    OTHERS.put(Preset.GAP, both);
    OTHERS.put(Preset.CORNER, both);
    OTHERS.put(Preset.SHALLOW, EnumSet.of(Rival.SUBSTEPS));
    OTHERS.put(Preset.SLOW, EnumSet.noneOf(Rival.class));
    OTHERS.put(Preset.WEDGE, EnumSet.noneOf(Rival.class));
    OTHERS.put(Preset.ROW, both); // the published algorithm knows no circles that collide
  }

  @ParameterizedTest
  @EnumSource
  void eachPresetShowsWhoFailsWithinFiveSeconds(Preset preset) {
    Reference truth = preset.truth();
    Set<Rival> failing = EnumSet.noneOf(Rival.class);
    for (Rival rival : Rival.values()) {
      try (Duel duel = new Duel(preset.scene(), rival, truth)) {
        if (duel.rivalScore(Preset.FRAMES).stream().anyMatch(ScoreLine::bad)) {
          failing.add(rival);
        }
        assertThat(duel.caromScore(Preset.FRAMES)).noneMatch(ScoreLine::bad);
        PlayedFrame end = duel.carom(Preset.FRAMES);
        assertThat(end.lost()).isZero();
        assertThat(end.penetration()).isLessThan(1e-12);
        if (truth != null) {
          double[] errors = duel.errors(end, Preset.FRAMES);
          assertThat(errors[errors.length - 1]).isLessThan(1e-6);
        }
      }
    }
    assertThat(failing).containsAll(ENGINES).containsAll(OTHERS.get(preset));
  }

  @Test
  void whatWasPlayedCanBeSeenAgainToTheBit() {
    Scene scene = Preset.FAST.scene();
    World world = new World(scene);
    try (Duel duel = new Duel(scene, Rival.SUBSTEPS, null)) {
      PlayedFrame there = duel.rival(40);
      duel.carom(90);
      duel.rival(90);
      for (int frame = 0; frame <= 90; frame += 10) {
        world.advanceTo(frame);
        for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
          assertThat(duel.carom(frame).x(i)).isEqualTo(world.x(i));
          assertThat(duel.carom(frame).vy(i)).isEqualTo(world.vy(i));
        }
      }
      assertThat(duel.rival(40)).isSameAs(there);
    }
  }

  @Test
  void aScoreTellsAgainstWhatItIsHeld() {
    Reference truth = Preset.SLOW.truth();
    try (Duel known = new Duel(Preset.SLOW.scene(), Rival.SUBSTEPS, truth);
        Duel unknown = new Duel(Preset.SLOW.scene(), Rival.SUBSTEPS, null)) {
      assertThat(texts(known.rivalScore(10)).get(3)).startsWith("error against the truth: ");
      assertThat(texts(known.rivalScore(Preset.FRAMES + 1)).get(3))
          .startsWith("error against Carom: ");
      assertThat(texts(unknown.rivalScore(10)).get(3)).startsWith("error against Carom: ");
      assertThat(texts(unknown.caromScore(10)).get(3))
          .isEqualTo("error: the truth is not known here");
      assertThat(texts(unknown.caromScore(0)))
          .containsExactly(
              "lost: 0 of 6",
              "deepest overlap: 0 radii",
              "energy: 100.00 %",
              "error: the truth is not known here",
              "time: no frame yet");
      assertThat(texts(unknown.rivalScore(10)).get(4)).matches("time: [0-9.,e-]+ µs a frame");
    }
  }

  private static List<String> texts(List<ScoreLine> lines) {
    return lines.stream().map(ScoreLine::text).toList();
  }

  @Test
  void countsWhoIsLostOnceAndForEver() {
    SceneBuilder setup =
        Scene.builder().collide(false).line(50, -50, 50, 150).circle(20, 30, 5, 0, 0);
    Scene thin = setup.circle(20, 70, 1, 64, 0).build();
    try (Duel duel = new Duel(thin, Rival.SUBSTEPS, null)) {
      assertThat(duel.rival(1).lost()).isEqualTo(1);
      assertThat(duel.rival(50).isLost(1)).isTrue();
      assertThat(duel.carom(50).lost()).isZero();
      assertThat(duel.rivalScore(50).get(0)).isEqualTo(new ScoreLine("lost: 1 of 2", true));
    }
  }

  @Test
  void saysWhyARivalDoesNotPlay() {
    try (Duel duel = new Duel(Preset.ROW.scene(), Rival.PUBLISHED, null)) {
      assertThat(duel.rivalScore(30))
          .containsExactly(
              new ScoreLine(
                  "does not play: this scene is not for this method: its circles collide; expected"
                      + " circles that ignore each other",
                  true));
      assertThat(duel.rival(30).x(0)).isEqualTo(duel.rival(0).x(0));
    }
  }

  /** In free fall the engine is ahead by g t h / 2, here 0.5 px: a thousandth of the height. */
  @Test
  void theEnergyUnderGravityIsThatOfThePlaceToo() {
    Scene scene =
        Scene.builder().bounds(0, 0, 800, 600).gravity(0, -0.1).circle(50, 500, 10, 0, 0).build();
    try (Duel duel = new Duel(scene, Rival.DYN4J_BEST, null)) {
      assertThat(duel.rival(10).vy(0)).isCloseTo(-1, within(1e-6));
      assertThat(duel.rival(10).energy()).isBetween(0.998, 1.0);
    }
    Scene open = Scene.builder().gravity(0, -0.1).circle(50, 500, 10, 1, 0).build();
    try (Duel duel = new Duel(open, Rival.DYN4J_BEST, null)) {
      assertThat(texts(duel.rivalScore(10)))
          .contains("energy: not judged, a fall without bounds has no end");
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"PUBLISHED", "SUBSTEPS"})
  void whoKnowsNoGravitySaysSo(Rival rival) {
    Scene scene = Scene.builder().gravity(0, -0.1).circle(50, 500, 10, 1, 0).build();
    try (Duel duel = new Duel(scene, rival, null)) {
      assertThat(texts(duel.rivalScore(9)))
          .containsExactly(
              "does not play: this scene is not for this method: it has gravity; expected circles"
                  + " that fly straight");
    }
  }

  /** Nobody but this library moves obstacles. */
  @ParameterizedTest
  @EnumSource
  void noRivalPlaysAmongObstaclesThatMove(Rival rival) {
    Scene scene =
        Scene.builder().line(50, 0, 50, 90).velocity(1, 0).circle(20, 30, 5, 2, 0).build();
    try (Duel duel = new Duel(scene, rival, null)) {
      assertThat(duel.rivalScore(9))
          .containsExactly(
              new ScoreLine(
                  "does not play: this scene is not for this method: lines or pegs move; expected"
                      + " obstacles at rest",
                  true));
      assertThat(texts(duel.caromScore(9)))
          .containsExactly("not judged: lines or pegs of this scene move");
    }
  }
}
