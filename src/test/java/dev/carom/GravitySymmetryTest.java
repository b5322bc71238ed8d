// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Falling.box;
import static dev.carom.Falling.rows;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** What must not change a run under gravity: scales of two and mirrors. */
class GravitySymmetryTest {

  /** No bit changes where all lengths are doubled, and times stay. */
  @Test
  void powersOfTwoScaleARun() {
    for (int seed = 0; seed < 20; seed++) {
      World world = new World(random(seed));
      World scaled = new World(transformed(random(seed), 4, 4, 0, 0));
      rows(world, 8);
      rows(scaled, 8);
      for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
        assertThat(scaled.x(i)).as("seed %d circle %d", seed, i).isEqualTo(4 * world.x(i));
        assertThat(scaled.y(i)).isEqualTo(4 * world.y(i));
        assertThat(scaled.vx(i)).isEqualTo(4 * world.vx(i));
      }
    }
  }

  @Test
  void mirrorsMirrorARun() {
    for (int seed = 0; seed < 20; seed++) {
      World world = new World(random(seed));
      World mirrored = new World(transformed(random(seed), -1, 1, 0, 0));
      World turned = new World(transformed(random(seed), -1, -1, 0, 0));
      assertThat(rows(mirrored, 8)).as("seed %d", seed).isEqualTo(rows(world, 8));
      rows(turned, 8);
      for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
        assertThat(mirrored.x(i)).as("seed %d circle %d", seed, i).isEqualTo(-world.x(i));
        assertThat(mirrored.y(i)).isEqualTo(world.y(i));
        assertThat(turned.y(i)).isEqualTo(-world.y(i));
      }
    }
  }

  /** The scene with x and y multiplied, then moved; gravity and velocities multiplied too. */
  private static Scene transformed(Scene scene, double mx, double my, double dx, double dy) {
    double size = Math.abs(mx);
    SceneBuilder builder = Scene.builder().collide(scene.collide());
    Bounds b = scene.bounds().orElseThrow();
    builder.bounds(
        Math.min(mx * b.xmin(), mx * b.xmax()) + dx,
        Math.min(my * b.ymin(), my * b.ymax()) + dy,
        Math.max(mx * b.xmin(), mx * b.xmax()) + dx,
        Math.max(my * b.ymin(), my * b.ymax()) + dy);
    builder.gravity(mx * scene.gravity().x(), my * scene.gravity().y());
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      Line l = (Line) scene.shape(Kind.LINE, i);
      builder.line(mx * l.ax() + dx, my * l.ay() + dy, mx * l.bx() + dx, my * l.by() + dy);
      builder.restitution(scene.traits(Kind.LINE, i).restitution());
    }
    for (int i = 0; i < scene.count(Kind.PEG); i++) {
      Circle c = (Circle) scene.shape(Kind.PEG, i);
      builder.peg(mx * c.x() + dx, my * c.y() + dy, size * c.radius());
      builder.restitution(scene.traits(Kind.PEG, i).restitution());
    }
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      Circle c = (Circle) scene.shape(Kind.CIRCLE, i);
      Vec2 v = scene.velocity(Kind.CIRCLE, i);
      builder.circle(mx * c.x() + dx, my * c.y() + dy, size * c.radius(), mx * v.x(), my * v.y());
      builder.restitution(scene.traits(Kind.CIRCLE, i).restitution());
    }
    return builder.build();
  }

  /** A box with lines, pegs and circles, elastic or not, that collide or not. */
  static Scene random(int seed) {
    Random random = new Random(seed);
    SceneBuilder builder = box().collide(seed % 2 == 0);
    for (int i = 0; i < 12; i++) {
      double x = 5 + 90 * random.nextDouble();
      double y = 5 + 50 * random.nextDouble();
      builder.line(x, y, x + 20 * random.nextDouble(), y + 8 * random.nextGaussian());
      builder.restitution(random.nextInt(3) / 2.0);
      builder.peg(5 + 90 * random.nextDouble(), 5 + 50 * random.nextDouble(), 3);
    }
    for (int i = 0; i < 12; i++) {
      builder.circle(8 + 7 * i, 80 + 3 * (i % 3), 1 + 0.1 * i, 3 * random.nextGaussian(), 0);
      builder.restitution(seed % 4 < 2 ? 1 : random.nextDouble());
    }
    return builder.build();
  }
}
