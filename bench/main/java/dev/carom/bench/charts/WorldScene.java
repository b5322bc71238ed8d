// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Obstacle;
import dev.carom.Outline;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Timeline;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.Optional;

/**
 * A world at one moment, as a scene: to be drawn, or saved. Removed things are not in it, so its
 * numbers need not be the world's ids.
 */
public final class WorldScene {

  private final World world;
  private final SceneBuilder builder = Scene.builder();

  private WorldScene(World world) {
    this.world = world;
  }

  /**
   * A world as it stands: what is there now; circles that flew out of the range of doubles are not.
   */
  public static Scene of(World world) {
    WorldScene now = new WorldScene(world);
    now.whole();
    for (int id : world.ids(Kind.LINE)) {
      now.line(id, world.shape(Kind.LINE, id));
    }
    for (int id : world.ids(Kind.PEG)) {
      now.peg(id, world.peg(id));
    }
    for (int id : world.ids(Kind.CIRCLE)) {
      now.circle(id);
    }
    return now.builder.build();
  }

  /**
   * A world as it was.
   *
   * @param t a time within the recording * @return what was there then, with the properties that it
   *     had then * window shows gravity as it is now, and can change it)
   * @throws IllegalArgumentException if the time is not within the recording
   */
  public static Scene of(World world, Timeline past, double t) {
    World then = new World(world.scene());
    then.restore(past.snapshot(t));
    return of(then);
  }

  private void whole() {
    Vec2 g = world.gravity();
    builder.collide(world.scene().collide()).gravity(g.x(), g.y());
    Optional<Bounds> bounds = world.scene().bounds();
    if (bounds.isPresent()) {
      Bounds b = bounds.get();
      builder.bounds(b.xmin(), b.ymin(), b.xmax(), b.ymax());
      keep(Kind.WALL, 0);
    }
  }

  private void line(int id, Obstacle shape) {
    if (shape instanceof Line line) {
      builder.line(line.ax(), line.ay(), line.bx(), line.by());
    } else {
      builder.outline((Outline) shape);
    }
    keep(Kind.LINE, id);
    keepVelocity(Kind.LINE, id);
  }

  private void peg(int id, Circle peg) {
    builder.peg(peg.x(), peg.y(), peg.radius());
    keep(Kind.PEG, id);
    keepVelocity(Kind.PEG, id);
  }

  private void circle(int id) {
    double x = world.x(id);
    double y = world.y(id);
    if (Double.isFinite(x) && Double.isFinite(y)) {
      builder.circle(x, y, world.radius(id), world.vx(id), world.vy(id));
      keep(Kind.CIRCLE, id);
    }
  }

  /** Gives the thing added last what the world's thing has. */
  private void keep(Kind kind, int id) {
    builder.traits(world.traits(kind, id));
  }

  private void keepVelocity(Kind kind, int id) {
    Vec2 v = world.velocity(kind, id);
    builder.velocity(v.x(), v.y());
  }
}
