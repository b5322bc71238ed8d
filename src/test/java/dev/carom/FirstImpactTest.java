// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.NearlyAtOnce.Truth;
import dev.carom.internal.state.EngineOptions;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * The first impact of a cast among several whose times round to the same double: the one that is
 * exactly earlier. If the times are exactly equal, it is the first in the order of codes.
 */
class FirstImpactTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private static final List<EngineOptions> MACHINERY =
      List.of(
          EngineOptions.CHOSEN,
          EngineOptions.EACH,
          EngineOptions.cells(0.5),
          EngineOptions.cells(3),
          EngineOptions.cells(40));

  @Tag("long")
  @Test
  void theFirstImpactIsThatOfTheOracle() {
    int rivals = 0;
    for (int seed = 0; seed < 1_000; seed++) {
      NearlyAtOnce scene = new NearlyAtOnce(new Random(seed));
      Truth still = scene.first(false);
      Truth moving = scene.first(true);
      for (double T : windows(still)) {
        Impact expected = impact(scene, still, T);
        assertThat(Resolver.of(obstacles(scene)).cast(new SweptCircle(scene.circle, scene.v), T))
            .as("seed %s", seed)
            .isEqualTo(Optional.ofNullable(expected));
        EngineOptions options = MACHINERY.get(seed % MACHINERY.size());
        assertThat(world(scene, false, options).cast(new SweptCircle(scene.circle, scene.v), T))
            .as("seed %s, %s", seed, options)
            .isEqualTo(Optional.ofNullable(expected));
      }
      for (double T : windows(moving)) {
        EngineOptions options = MACHINERY.get(seed / 2 % MACHINERY.size());
        assertThat(world(scene, true, options).cast(new SweptCircle(scene.circle, scene.v), T))
            .as("seed %s, %s, circles collide", seed, options)
            .isEqualTo(Optional.ofNullable(impact(scene, moving, T)));
      }
      rivals += moving != null && scene.rivals(true) > 0 ? 1 : 0;
    }
    assertThat(rivals).isGreaterThan(300);
  }

  private static double[] windows(Truth first) {
    if (first == null) {
      return new double[] {NEVER};
    }
    double t = first.contact().time();
    return new double[] {NEVER, t, Math.nextUp(t), Math.max(0, Math.nextDown(t))};
  }

  /** The impact that the detector tells of the thing that is first by the oracle. */
  private static Impact impact(NearlyAtOnce scene, Truth first, double T) {
    if (first == null || !first.contact().moment().within(T)) {
      return null;
    }
    int id = first.id();
    Optional<Impact> impact =
        switch (first.kind()) {
          case WALL -> new SweptCircle(scene.circle, scene.v).cast(scene.bounds, NEVER);
          case LINE -> new SweptCircle(scene.circle, scene.v).cast(scene.lines.get(id), NEVER);
          case PEG -> new SweptCircle(scene.circle, scene.v).cast(scene.pegs.get(id), NEVER);
          default ->
              new SweptCircle(scene.circle, scene.v)
                  .cast(new SweptCircle(scene.circles.get(id), scene.velocities.get(id)), NEVER);
        };
    assertThat(impact.orElseThrow().time()).isEqualTo(first.contact().time());
    return WorldQueriesTest.named(impact.get(), first.kind(), id);
  }

  private static List<Obstacle> obstacles(NearlyAtOnce scene) {
    List<Obstacle> all = new ArrayList<>(scene.lines);
    all.addAll(scene.pegs);
    if (scene.bounds != null) {
      all.add(scene.bounds);
    }
    return all;
  }

  /** A circle of radius 5 stands aside where circles do not count: grids are made for it. */
  private static World world(NearlyAtOnce scene, boolean collide, EngineOptions options) {
    SceneBuilder builder = Scene.builder().collide(collide);
    Bounds b = scene.bounds;
    if (b != null) {
      builder.bounds(b.xmin(), b.ymin(), b.xmax(), b.ymax());
    }
    scene.lines.forEach(line -> builder.line(line.ax(), line.ay(), line.bx(), line.by()));
    scene.pegs.forEach(peg -> builder.peg(peg.x(), peg.y(), peg.radius()));
    for (int i = 0; collide && i < scene.circles.size(); i++) {
      Circle c = scene.circles.get(i);
      builder.circle(
          c.x(), c.y(), c.radius(), scene.velocities.get(i).x(), scene.velocities.get(i).y());
    }
    return new World((collide ? builder : builder.circle(0, 0, 5, 0, 0)).build(), options);
  }
}
