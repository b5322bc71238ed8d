// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.engine.Engine;
import dev.carom.internal.query.Warnings;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.WorldState;

/** Access to parts of public types, for tests in the internal packages. */
@SuppressWarnings("exports")
public final class Internals {

  private Internals() {}

  /** The arrays of a scene. */
  public static SceneData data(Scene scene) {
    return scene.data;
  }

  /** A world whose engine is told how to work. */
  public static World world(Scene scene, EngineOptions options) {
    return new World(scene, options);
  }

  /** The engine of a world. */
  public static Engine engine(World world) {
    return world.engine;
  }

  /** The state in a snapshot. */
  public static WorldState state(Snapshot snapshot) {
    return snapshot.state;
  }

  /** The circles of a world, as its engine holds them. */
  public static CircleTable circles(World world) {
    return world.circles;
  }

  /** A snapshot that holds a state. */
  public static Snapshot snapshot(WorldState state) {
    return new Snapshot(state);
  }

  /** The log that shows some rows. */
  public static ImpactLog log(ImpactRows rows) {
    return new ImpactLog(rows);
  }

  /** The warning of an overlap. */
  public static Warning warning(Scene scene, Warnings.Overlap overlap) {
    return scene.warning(overlap);
  }

  /** The record of an obstacle. */
  public static Obstacle record(ObstacleTable obstacles, int code) {
    return PublicRecords.of(obstacles, code, 0);
  }
}
