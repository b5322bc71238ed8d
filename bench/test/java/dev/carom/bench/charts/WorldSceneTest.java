// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Filter;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Timeline;
import dev.carom.Traits;
import dev.carom.Vec2;
import dev.carom.World;
import org.junit.jupiter.api.Test;

/** A world as a scene: all that it holds, edits included, so that it can be saved. */
class WorldSceneTest {

  private static SceneBuilder start() {
    SceneBuilder builder = Scene.builder();
    builder.bounds(0, 0, 100, 60).response(Response.HALT).filter(new Filter(7, 6));
    builder.line(10, 10, 20, 20).restitution(0.5).oneWay().filter(new Filter(4, -1));
    builder.peg(50, 50, 2).response(Response.SENSOR);
    return builder
        .circle(30, 30, 5, 1, 0)
        .mass(3)
        .restitution(0.25)
        .filter(new Filter(2, 3))
        .collide(true);
  }

  @Test
  void aWorldThatStandsAtItsStartIsItsScene() {
    Scene scene = start().build();
    assertThat(WorldScene.of(new World(scene))).isEqualTo(scene);
  }

  @Test
  void whatEditsChangedIsInIt() {
    World world = new World(start().build());
    Timeline past = world.record(10);
    world.step(1);
    world.setTraits(Kind.LINE, 0, world.traits(Kind.LINE, 0).withOneWay(false));
    world.setTraits(Kind.WALL, 0, world.traits(Kind.WALL, 0).withRestitution(0.75));
    world.setTraits(Kind.PEG, 0, world.traits(Kind.PEG, 0).withRestitution(2));
    world.setTraits(Kind.PEG, 0, world.traits(Kind.PEG, 0).withResponse(Response.HALT));
    world.addLine(70, 10, 80, 10, Traits.DEFAULT.withRestitution(0.125));
    world.setTraits(Kind.PEG, 0, world.traits(Kind.PEG, 0).withFilter(new Filter(8, 9)));
    world.remove(Kind.CIRCLE, 0);
    Scene now = WorldScene.of(world);
    assertThat(now.traits(Kind.WALL, 0).restitution()).isEqualTo(0.75);
    assertThat(now.traits(Kind.WALL, 0).response()).isEqualTo(Response.HALT);
    assertThat(now.traits(Kind.LINE, 0).oneWay()).isFalse();
    assertThat(now.traits(Kind.LINE, 0).restitution()).isEqualTo(0.5);
    assertThat(now.traits(Kind.LINE, 1).restitution()).isEqualTo(0.125);
    assertThat(now.traits(Kind.PEG, 0).restitution()).isEqualTo(2);
    assertThat(now.traits(Kind.PEG, 0).response()).isEqualTo(Response.HALT);
    assertThat(now.traits(Kind.PEG, 0).filter().category()).isEqualTo(8);
    assertThat(now.traits(Kind.PEG, 0).filter().mask()).isEqualTo(9);
    assertThat(now.traits(Kind.WALL, 0).filter().category()).isEqualTo(7);
    assertThat(now.count(Kind.CIRCLE)).isZero();

    Scene then = WorldScene.of(world, past, 0.5);
    assertThat(((Circle) then.shape(Kind.CIRCLE, 0)).x()).isEqualTo(30.5);
    assertThat(then.traits(Kind.CIRCLE, 0).mass()).isEqualTo(3);
    assertThat(then.traits(Kind.CIRCLE, 0).restitution()).isEqualTo(0.25);
    assertThat(then.count(Kind.LINE)).isEqualTo(1);
    assertThat(then.traits(Kind.LINE, 0).oneWay()).isTrue();
    assertThat(then.traits(Kind.WALL, 0).restitution()).isEqualTo(1);
    assertThat(then.traits(Kind.PEG, 0).restitution()).isEqualTo(1);
    assertThat(then.traits(Kind.PEG, 0).response()).isEqualTo(Response.SENSOR);
  }

  @Test
  void gravityIsInIt() {
    World world = new World(start().gravity(0.5, -2).build());
    Timeline past = world.record(10);
    assertThat(WorldScene.of(world)).isEqualTo(world.scene());
    assertThat(WorldScene.of(world, past, 0).gravity()).isEqualTo(new Vec2(0.5, -2));
    world.setGravity(0, -1);
    assertThat(WorldScene.of(world).gravity()).isEqualTo(new Vec2(0, -1));
  }

  /** Where they are at the moment shown, live and in the past, and going on from there. */
  @Test
  void obstaclesThatMoveAreInItWhereTheyAre() {
    Scene start = start().line(0, 0, 0, 9).velocity(2, 1).peg(80, 20, 3).velocity(-0.5, 0).build();
    World world = new World(start);
    assertThat(WorldScene.of(world)).isEqualTo(start);
    Timeline past = world.record(10);
    world.step(4);
    Scene now = WorldScene.of(world);
    Scene then = WorldScene.of(world, past, 1);
    assertThat(now.shape(Kind.LINE, 1)).isEqualTo(new Line(8, 4, 8, 13));
    assertThat(now.shape(Kind.PEG, 1)).isEqualTo(new Circle(78, 20, 3));
    assertThat(then.shape(Kind.LINE, 1)).isEqualTo(new Line(2, 1, 2, 10));
    assertThat(then.shape(Kind.PEG, 1)).isEqualTo(new Circle(79.5, 20, 3));
    for (Scene scene : new Scene[] {now, then}) {
      assertThat(scene.velocity(Kind.LINE, 1)).isEqualTo(new Vec2(2, 1));
      assertThat(scene.velocity(Kind.PEG, 1)).isEqualTo(new Vec2(-0.5, 0));
      assertThat(scene.velocity(Kind.LINE, 0)).isEqualTo(Vec2.ZERO);
    }
  }

  /** An obstacle that was stopped since, or removed, was moving then. */
  @Test
  void thePastHasTheVelocitiesOfThen() {
    World world =
        new World(start().line(0, 0, 0, 9).velocity(2, 1).peg(80, 20, 3).velocity(-1, 0).build());
    Timeline past = world.record(10);
    world.step(2);
    world.setVelocity(Kind.LINE, 1, 0, 0);
    world.remove(Kind.PEG, 1);
    Scene then = WorldScene.of(world, past, 1);
    assertThat(then.velocity(Kind.LINE, 1)).isEqualTo(new Vec2(2, 1));
    assertThat(then.velocity(Kind.PEG, 1)).isEqualTo(new Vec2(-1, 0));
  }
}
