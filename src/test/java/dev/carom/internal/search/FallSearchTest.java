// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Internals;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** With a grid, the search finds what it finds if it tests each obstacle. */
class FallSearchTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** The sides of the square in which the lines and pegs are. */
  private static final double SIZE = 100;

  private final Random random = new Random(1);

  /** A circle that has to be followed, and what it meets first. */
  private record Trial(MovingCircle followed, MovingCircle direct) {

    static Trial of(
        ObstacleTable obstacles, Grid grid, MovingCircle start, double end, int lookahead) {
      FlightSearch search = new FlightSearch(obstacles, new CodeSet());
      MovingCircle direct = copy(start);
      search.extend(direct, null, end);
      MovingCircle followed = copy(start);
      followed.lookahead = lookahead;
      double needed = end / 8;
      do {
        search.extend(followed, grid, needed);
        needed *= 2;
      } while (followed.next == MovingCircle.NOTHING && followed.cleared <= end);
      return new Trial(followed, direct);
    }

    private static MovingCircle copy(MovingCircle m) {
      MovingCircle copy = new MovingCircle();
      copy.start(0, m.x, m.y, m.radius, m.vx, m.vy, 1);
      copy.fall(m.gx, m.gy);
      return copy;
    }

    void assertSame(double end) {
      if (direct.next != MovingCircle.NOTHING && direct.cleared <= end) {
        assertThat(followed.cleared).isEqualTo(direct.cleared);
        assertThat(followed.next).isEqualTo(direct.next);
        assertThat(followed.contact).isEqualTo(direct.contact);
      } else if (followed.next != MovingCircle.NOTHING) {
        assertThat(followed.cleared).isGreaterThan(end);
      }
    }
  }

  private ObstacleTable obstacles(boolean hasWalls) {
    SceneBuilder scene = Scene.builder();
    if (hasWalls) {
      scene.bounds(-SIZE, -SIZE, 2 * SIZE, 2 * SIZE);
    }
    for (int i = 0; i < 30; i++) {
      double x = SIZE * random.nextDouble();
      double y = SIZE * random.nextDouble();
      scene.line(x, y, x + 4 * random.nextGaussian(), y + 4 * random.nextGaussian());
    }
    for (int i = 0; i < 5; i++) {
      scene.peg(SIZE * random.nextDouble(), SIZE * random.nextDouble(), random.nextDouble());
    }
    return ObstacleTable.of(Internals.data(scene.build()));
  }

  private double maybe(double value) {
    return random.nextInt(4) == 0 ? 0 : value;
  }

  /** A circle that starts inside of the grid, or so far outside. */
  private MovingCircle circle(double away, double speed, double gravity) {
    MovingCircle m = new MovingCircle();
    double x = SIZE / 2 + (SIZE / 2 + away) * (2 * random.nextDouble() - 1);
    double y = SIZE / 2 + (SIZE / 2 + away) * (2 * random.nextDouble() - 1);
    double vx = maybe(speed * random.nextGaussian());
    double vy = maybe(speed * random.nextGaussian());
    m.start(0, x, y, 1, vx, vy, 1);
    m.fall(maybe(gravity * random.nextGaussian()), gravity * random.nextGaussian());
    return m;
  }

  /** The times of the trials are such that the path is some times as long as the grid. */
  @ParameterizedTest
  @CsvSource({
    "0, 1, 0.01, 400, 8000",
    "0, 10, 1, 60, 8000",
    "0, 0.001, 100, 4, 8000",
    "300, 10, 1, 60, 8000",
    "300, 30, 0.1, 600, 8000",
    "3, 5, 1, 40, 8000",
    "0, 1e3, 1e-3, 1, 8000",
    "0, 1e-100, 1e-200, 4e100, 500",
    "0, 1e60, 1e120, 1e-59, 100",
    "1000, 1e150, 1e298, 1e-147, 100"
  })
  void itFindsTheSameAsATestOfEachObstacle(
      double away, double speed, double gravity, double end, int trials) {
    int hits = 0;
    for (int i = 0; i < trials; i++) {
      ObstacleTable obstacles = obstacles(i % 3 == 0);
      double margin = i % 2 == 0 ? Grid.MARGIN : Grid.MARGIN_OF_FALLS;
      Grid grid = new Grid(obstacles, 1, i % 5 == 0 ? 3 : 0, margin);
      MovingCircle start = circle(away, speed, gravity);
      Trial trial = Trial.of(obstacles, grid, start, end, i % 7 == 0 ? 1 : 64);
      trial.assertSame(end);
      hits += trial.direct.next != MovingCircle.NOTHING ? 1 : 0;
    }
    assertThat(hits).isBetween(trials / 50, trials - 1);
  }

  /** Beyond the range of lengths of pieces; the last one falls by half the size of the scene. */
  @ParameterizedTest
  @CsvSource({
    "1, 1e-310, 1e156",
    "1, 5e-324, 1e163",
    "1e-100, 1e300, 1e-198",
    "1e-100, 1e-300, 1e101",
    "1e100, 1e-210, 1e156",
    "1, 1, 20"
  })
  void itFindsTheSameUnderTheLeastAndTheLargestAccelerations(
      double scale, double gravity, double end) {
    int hits = 0;
    for (int i = 0; i < 50; i++) {
      SceneBuilder scene = Scene.builder();
      for (int k = 0; k < 20; k++) {
        double x = scale * random.nextDouble() * SIZE;
        double y = scale * random.nextDouble() * SIZE;
        scene.line(x, y, x + 10 * scale, y + scale * random.nextGaussian());
      }
      ObstacleTable obstacles = ObstacleTable.of(Internals.data(scene.build()));
      Grid grid = new Grid(obstacles, scale, 0, Grid.MARGIN_OF_FALLS);
      MovingCircle m = new MovingCircle();
      m.start(0, scale * random.nextDouble() * SIZE, scale * SIZE, scale, 0, 0, 1);
      m.fall(0, -gravity);
      Trial trial = Trial.of(obstacles, grid, m, end, 64);
      trial.assertSame(end);
      hits += trial.direct.next != MovingCircle.NOTHING && trial.direct.cleared <= end ? 1 : 0;
    }
    assertThat(hits).isGreaterThan(10);
  }

  /** The path turns at a border between cells, at the edge of the grid or just beyond it. */
  @Test
  void itFindsTheSameAfterATurnAtABorder() {
    ObstacleTable obstacles = obstacles(false);
    Grid grid = new Grid(obstacles, 1, 4, Grid.MARGIN_OF_FALLS);
    double edge = -grid.rows(0) * grid.cell;
    int hits = 0;
    for (int i = 0; i < 20_000; i++) {
      double border = edge + random.nextInt(grid.rows + 1) * grid.cell;
      double off = (random.nextInt(9) - 4) * (i % 3 == 0 ? 0x1p-46 : 0x1p-3 * grid.cell);
      double height = (SIZE + 20) * random.nextDouble() - 10;
      double way = border + off - height;
      double g = way > 0 ? -1 : 1;
      MovingCircle m = new MovingCircle();
      double x = SIZE * random.nextDouble();
      m.start(0, x, height, 1, maybe(random.nextGaussian()), -g * Math.sqrt(2 * way / -g), 1);
      m.fall(0, g);
      Trial trial = Trial.of(obstacles, grid, m, 40, 64);
      trial.assertSame(40);
      hits += trial.direct.next != MovingCircle.NOTHING ? 1 : 0;
    }
    assertThat(hits).isGreaterThan(1000);
  }

  /** High above the grid no obstacle is tested; the path is known up to where it comes back. */
  @Test
  void itKnowsWhenThePathComesBackToTheGrid() {
    FallPath path = new FallPath();
    ObstacleTable obstacles = obstacles(false);
    Grid grid = new Grid(obstacles, 1, 4, Grid.MARGIN_OF_FALLS);
    MovingCircle m = new MovingCircle();
    m.start(0, SIZE / 2, SIZE / 2, 1, 0.01, 1000, 1);
    m.fall(0, -1);
    path.start(m);
    double entry = path.entry(grid, 1000);
    double top = grid.rows - grid.rows(SIZE / 2);
    assertThat(path.isInside(grid, 1000)).isFalse();
    assertThat(entry).isCloseTo(2000 - top * grid.cell / 1000, within(0.01));
    assertThat(path.isInside(grid, entry)).isTrue();
    assertThat(path.entry(grid, 3000)).isEqualTo(NEVER);
  }

  @Test
  void aPathBesideTheGridNeverEntersIt() {
    FallPath path = new FallPath();
    Grid grid = new Grid(obstacles(false), 1, 4, Grid.MARGIN_OF_FALLS);
    MovingCircle m = new MovingCircle();
    m.start(0, 2 * SIZE, 0, 1, 1, 1000, 1);
    m.fall(0, -1);
    path.start(m);
    assertThat(path.entry(grid, 0)).isEqualTo(NEVER);
  }
}
