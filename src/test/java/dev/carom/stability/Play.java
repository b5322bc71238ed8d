// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Feature;
import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Outcome;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.ArrayList;
import java.util.List;

/** Plays scenes, and looks at what is left of them. */
final class Play {

  private Play() {}

  /** A row of an impact log. */
  record Hit(
      double time,
      int circle,
      Kind kind,
      int obstacle,
      Feature feature,
      double speed,
      Outcome outcome) {}

  /** Where a circle is, and its velocity. */
  record State(double x, double y, double vx, double vy) {}

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
  static List<Hit> advance(World world, double t) {
    world.advanceTo(t);
    return hits(world);
  }

  /** Advances a world to a time in as many calls as it takes, at most so many. */
  static List<Hit> finish(World world, double t, int calls) {
    List<Hit> hits = new ArrayList<>();
    for (int call = 0; call < calls; call++) {
      boolean complete = world.advanceTo(t, Run.WORK);
      hits.addAll(hits(world));
      if (complete) {
        return hits;
      }
    }
    throw new AssertionError("not finished in " + calls + " calls: at " + world.now());
  }

  static List<Hit> hits(World world) {
    ImpactLog log = world.impacts();
    List<Hit> hits = new ArrayList<>();
    for (int i = 0; i < log.size(); i++) {
      hits.add(
          new Hit(
              log.time(i),
              log.circle(i),
              log.kind(i),
              log.id(i),
              log.feature(i),
              log.approachSpeed(i),
              log.outcome(i)));
    }
    return hits;
  }

  static List<State> states(World world) {
    List<State> states = new ArrayList<>();
    for (int id = 0; id < world.idLimit(Kind.CIRCLE); id++) {
      if (world.contains(Kind.CIRCLE, id)) {
        states.add(new State(world.x(id), world.y(id), world.vx(id), world.vy(id)));
      }
    }
    return states;
  }

  static double speed(World world, int id) {
    return Math.hypot(world.vx(id), world.vy(id));
  }

  static void assertState(World world, int id, double x, double y, double vx, double vy) {
    assertThat(new State(world.x(id), world.y(id), world.vx(id), world.vy(id)))
        .isEqualTo(new State(x, y, vx, vy));
  }
}
