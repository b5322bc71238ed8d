// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Line;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.ArrayList;
import java.util.List;

/** Plays scenes, and looks at what is left of them. */
final class Play {

  private Play() {}

  static World world(SceneBuilder builder) {
    return new World(builder.build());
  }

  /** A scene of lines, to which circles can be added. */
  static SceneBuilder among(Line... lines) {
    SceneBuilder builder = Scene.builder();
    for (Line line : lines) {
      builder.line(line.ax(), line.ay(), line.bx(), line.by());
    }
    return builder;
  }

  /** Advances a world to a time, in one call, and returns the impacts. */
  static List<Run.Row> advance(World world, double t) {
    world.advanceTo(t);
    return Run.rows(world.impacts());
  }

  /** Advances a world to a time in as many calls as it takes, at most so many. */
  static List<Run.Row> finish(World world, double t, int calls) {
    List<Run.Row> hits = new ArrayList<>();
    for (int call = 0; call < calls; call++) {
      boolean complete = world.advanceTo(t, Run.WORK);
      hits.addAll(Run.rows(world.impacts()));
      if (complete) {
        return hits;
      }
    }
    throw new AssertionError("not finished in " + calls + " calls: at " + world.now());
  }

  static double speed(World world, int id) {
    return Math.hypot(world.vx(id), world.vy(id));
  }

  static void assertState(World world, int id, double x, double y, double vx, double vy) {
    assertThat(new Run.State(world.x(id), world.y(id), world.vx(id), world.vy(id)))
        .isEqualTo(new Run.State(x, y, vx, vy));
  }
}
