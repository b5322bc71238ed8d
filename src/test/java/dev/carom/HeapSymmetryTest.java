// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Heaps of 10 to 30 balls that come to rest in a box, between lines, in a wedge or on pegs. In a
 * mirror all rows are the same to the bit. So they are where all lengths, or all masses, are
 * multiplied by a power of four. With other ids for the balls the rows differ, but all come to
 * rest.
 */
class HeapSymmetryTest {

  private static final int SCENES = 6;

  /** All come to rest sooner. */
  private static final int SECONDS = 80;

  /** Where a scene is set: factors of x, of all lengths and of all masses, and the order of ids. */
  private record Setting(double mirror, double size, double mass, boolean backwards) {

    double x(double x) {
      return mirror * size * x;
    }

    double y(double y) {
      return size * y;
    }
  }

  private static final Setting PLAIN = new Setting(1, 1, 1, false);

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5})
  void aHeapComesToRestAlike(int seed) {
    List<Run.Row> rows = rows(seed, PLAIN);
    assertThat(rows).hasSizeGreaterThan(5);
    for (Setting setting :
        List.of(
            new Setting(-1, 1, 1, false),
            new Setting(1, 4, 1, false),
            new Setting(1, 0x1p-6, 1, false),
            new Setting(1, 1, 0x1p-20, false))) {
      assertThat(rows(seed, setting)).as("%s", setting).isEqualTo(rows);
    }
    assertThat(rows(seed, new Setting(1, 1, 1, true))).hasSizeGreaterThan(5);
  }

  /** Neither rests nor rolls on the floor, where nothing stops it. */
  private static boolean isMoving(World world, int i) {
    return !world.isResting(i) && (world.vy(i) != 0 || world.vx(i) == 0);
  }

  /** The rows until all balls rest, as they are in the plain setting. */
  private static List<Run.Row> rows(int seed, Setting setting) {
    World world = world(seed, setting);
    int balls = world.circleCount();
    List<Run.Row> rows = new ArrayList<>();
    while (world.now() == 0 || IntStream.range(0, balls).anyMatch(i -> isMoving(world, i))) {
      assertThat(world.now()).as("all rest by then, or roll").isLessThan(SECONDS);
      double end = world.now() + 0.5;
      boolean done;
      do {
        done = world.advanceTo(end);
        Run.rows(world.impacts()).forEach(row -> rows.add(plain(row, setting)));
      } while (!done);
    }
    assertThat(Falling.overlap(world)).isLessThan(1e-12 * setting.size);
    return rows;
  }

  /** A row as it is in the plain setting; 0 for -0. */
  private static Run.Row plain(Run.Row row, Setting setting) {
    boolean isAtSide = row.kind() == ObstacleKind.WALL && row.obstacle() <= 1;
    return new Run.Row(
        row.time(),
        row.circle(),
        row.kind(),
        isAtSide && setting.mirror < 0 ? 1 - row.obstacle() : row.obstacle(),
        row.feature(),
        row.x() / setting.x(1) + 0.0,
        row.y() / setting.size + 0.0,
        row.nx() * setting.mirror + 0.0,
        row.ny() + 0.0,
        row.speed() / setting.size,
        row.outcome());
  }

  private static World world(int seed, Setting at) {
    Random random = new Random(seed);
    SceneBuilder scene = Scene.builder().collide(true).gravity(0, at.y(-10));
    switch (seed % 4) {
      case 0 -> scene.bounds(at.y(-9), at.y(0), at.y(9), at.y(200));
      case 1 -> {
        scene.line(at.x(-9), at.y(0), at.x(9), at.y(0));
        scene.line(at.x(-9), at.y(0), at.x(-9), at.y(200));
        scene.line(at.x(9), at.y(0), at.x(9), at.y(200));
      }
      case 2 -> {
        scene.line(at.x(-200), at.y(150), at.x(0), at.y(0));
        scene.line(at.x(0), at.y(0), at.x(200), at.y(150));
      }
      default -> {
        scene.bounds(at.y(-12), at.y(0), at.y(12), at.y(200));
        for (int x = -9; x <= 9; x += 6) {
          scene.peg(at.x(x), at.y(2), at.y(1));
        }
      }
    }
    double e = 0.25 * (seed % 3);
    int count = 10 + 20 * seed / (SCENES - 1);
    Runnable[] balls = new Runnable[count];
    for (int i = 0; i < count; i++) {
      double x = 4 * (i % 4) - 6.5 + random.nextDouble();
      int row = i / 4;
      double y = 12 + 4.2 * row;
      double r = 1 + 0.5 * random.nextDouble();
      double vx = random.nextGaussian();
      double mass = random.nextInt(3) == 0 ? 4 : 1;
      balls[i] =
          () ->
              scene
                  .circle(at.x(x), at.y(y), at.y(r), at.x(vx), 0)
                  .mass(at.mass * mass)
                  .restitution(e);
    }
    for (int i = 0; i < count; i++) {
      balls[at.backwards ? count - 1 - i : i].run();
    }
    return new World(scene.build());
  }
}
