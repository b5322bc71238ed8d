// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Impact;
import dev.carom.Line;
import dev.carom.Outcome;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Causes that break collision code, one a row: what a naive method does there, the scene, the end,
 * and the number of impacts and the state of circle 0 in Carom's answer.
 */
class CausesTest {

  private static final Line FLOOR = new Line(-100, 0, 100, 0);
  private static final Line LEFT_OF_JOINT = new Line(0, 0, 10, 0);
  private static final Line RIGHT_OF_JOINT = new Line(10, 0, 20, 0);
  private static final Line WALL = new Line(0, 0, 0, 10);

  private static Run.State at(double x, double y, double vx, double vy) {
    return new Run.State(x, y, vx, vy);
  }

  /** A scene of lines, to which circles can be added. */
  private static SceneBuilder among(Line... lines) {
    SceneBuilder builder = Scene.builder();
    for (Line line : lines) {
      builder.line(line.ax(), line.ay(), line.bx(), line.by());
    }
    return builder;
  }

  static Stream<Arguments> causes() {
    return Stream.of(fast(), justTouching(), linesTogether(), started(), numbers())
        .flatMap(List::stream);
  }

  private static Arguments cause(
      String name, SceneBuilder scene, double end, int impacts, Run.State last) {
    return Arguments.of(name, scene, end, impacts, last);
  }

  private static List<Arguments> fast() {
    double speed = 0x1p40;
    double rest = speed * (1 - 9 / speed);
    return List.of(
        cause(
            "tunnels through a line, in substeps too",
            among(FLOOR).circle(0, 10, 1, 0, -speed),
            1,
            1,
            at(0, 1 + rest, 0, speed)),
        cause(
            "two circles change sides within a frame",
            Scene.builder().circle(0, 0, 1, speed, 0).circle(10, 0, 1, -speed, 0),
            8 / speed,
            1,
            at(0, 0, -speed, 0)));
  }

  /** The radius is lost in the square of the distance: b^2 - a c is 0 for both. */
  private static List<Arguments> justTouching() {
    double far = 1e8;
    double over = 1 + 1e-12;
    return List.of(
        cause(
            "hits what it passes",
            Scene.builder().peg(0, 0, 0).circle(-far, over, 1, 1, 0),
            2 * far,
            0,
            at(far, over, 1, 0)),
        cause(
            "takes a graze for a hit",
            Scene.builder().peg(0, 0, 0).circle(-far, 1, 1, 1, 0),
            2 * far,
            0,
            at(far, 1, 1, 0)));
  }

  private static List<Arguments> linesTogether() {
    Line[] joint = {LEFT_OF_JOINT, RIGHT_OF_JOINT};
    Line down = new Line(-32, 32, 0, 0);
    Line up = new Line(0, 0, 32, 32);
    double bottom = 2 * Math.sqrt(2);
    Line[] fan =
        IntStream.range(0, 10_000)
            .mapToDouble(i -> Math.PI * (1 + (i + 0.5) / 10_000))
            .mapToObj(a -> new Line(0, 0, 50 * Math.cos(a), 50 * Math.sin(a)))
            .toArray(Line[]::new);
    Line point = new Line(0, 0, 0, 0);
    return List.of(
        cause(
            "is turned round by each of two lines, so goes on",
            among(joint).circle(10, 3, 2, 0, -2),
            1,
            1,
            at(10, 3, 0, 2)),
        cause(
            "stops at the ghost of a joint over which it slides",
            among(joint).circle(3, 2, 2, 1, 0),
            100,
            0,
            at(103, 2, 1, 0)),
        cause(
            "drops the second impact of a frame, and the rest of it",
            among(down, up).circle(0, 16, 2, 0, -1),
            32,
            2,
            at(0, 16 + 2 * bottom, 0, 1)),
        cause(
            "is turned round by each of many lines that end in a point",
            among(fan).circle(0, 9, 1, 0, -1),
            16,
            1,
            at(0, 9, 0, 1)),
        cause(
            "divides by the length of a line that has none",
            among(point).circle(0, 9, 1, 0, -1),
            16,
            1,
            at(0, 9, 0, 1)),
        cause(
            "divides by the square of a short length, which underflows",
            among(new Line(0, 0, 1e-200, 0)).circle(0.6, 9, 1, 0, -1),
            16,
            1,
            at(0.6 + 0.96 * 7.8, 0.8 + 0.28 * 7.8, 0.96, 0.28)));
  }

  /** In touch, or inside. */
  private static List<Arguments> started() {
    return List.of(
        cause(
            "trembles in a corner",
            among(LEFT_OF_JOINT, WALL).circle(2, 2, 2, 0, 0),
            1e6,
            0,
            at(2, 2, 0, 0)),
        cause(
            "sinks into lines that it touches",
            among(LEFT_OF_JOINT, WALL).circle(2, 2, 2, -1, -2),
            3,
            2,
            at(5, 8, 1, 2)),
        cause(
            "falls through a line that it overlaps",
            among(FLOOR).circle(0, 0.5, 1, 0, -1),
            4,
            1,
            at(0, 4.5, 0, 1)),
        cause(
            "holds what leaves a line that it overlaps",
            among(FLOOR).circle(0, 0.5, 1, 3, 1e-300),
            1,
            0,
            at(3, 0.5, 3, 1e-300)),
        cause(
            "goes deeper into a peg that it overlaps",
            Scene.builder().peg(0, 0, 10).circle(3, 0, 1, -1, 0),
            20,
            1,
            at(23, 0, 1, 0)));
  }

  private static List<Arguments> numbers() {
    double small = 1e-200;
    double large = 0x1p510;
    double light = 0x1p-500;
    double heavy = Double.POSITIVE_INFINITY;
    double way = 5 - Math.sqrt(2);
    return List.of(
        cause(
            "squares of small lengths underflow",
            among(new Line(-10 * small, -10 * small, 10 * small, 10 * small))
                .circle(0, 5 * small, small, 0, -small),
            way,
            1,
            at(0, Math.sqrt(2) * small, -small, 0)),
        cause(
            "squares of large lengths overflow",
            Scene.builder().circle(0, 0, large, large, 0).circle(5 * large, 0, large, 0, 0),
            4,
            1,
            at(3 * large, 0, 0, 0)),
        cause(
            "an infinite mass makes no number",
            Scene.builder().circle(0, 0, 1, 1, 0).mass(light).circle(5, 0, 1, 0, 0).mass(heavy),
            6,
            1,
            at(0, 0, -1, 0)));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("causes")
  void isRightWhereNaiveMethodsFail(
      String name, SceneBuilder scene, double end, int impacts, Run.State right) {
    World world = new World(scene.build());
    world.advanceTo(end);
    assertThat(world.impacts().size()).isEqualTo(impacts);
    Run.State last = Run.states(world).get(0);
    double size = Math.max(Math.abs(right.x()), Math.abs(right.y()));
    double speed = Math.max(Math.abs(right.vx()), Math.abs(right.vy()));
    assertThat(last.x()).isCloseTo(right.x(), within(1e-13 * size));
    assertThat(last.y()).isCloseTo(right.y(), within(1e-13 * size));
    assertThat(last.vx()).isCloseTo(right.vx(), within(1e-14 * speed));
    assertThat(last.vy()).isCloseTo(right.vy(), within(1e-14 * speed));
  }

  /**
   * Corners down to a hundredth of a degree. Unfolded, the way in and out is a straight line
   * through pi / angle copies of the corner: so many reflections, or one less (see WedgeTest).
   */
  @ParameterizedTest
  @ValueSource(doubles = {30, 1, 0.01})
  void comesOutOfACorner(double degrees) {
    double angle = Math.toRadians(degrees);
    double length = 0x1p20;
    Line floor = new Line(0, 0, length, 0);
    Line roof = new Line(0, 0, length * Math.cos(angle), length * Math.sin(angle));
    // Along the bisector, from where there is room for eight of its diameters.
    double distance = 16 / Math.sin(angle);
    double x = distance * Math.cos(angle / 2);
    double y = distance * Math.sin(angle / 2);
    double vx = -x / distance;
    double vy = -y / distance + 1e-3 * angle;
    World world = new World(among(floor, roof).circle(x, y, 1, vx, vy).build());
    world.advanceTo(3 * distance);
    int most = (int) Math.ceil(Math.PI / angle - 1e-9);
    assertThat(world.impacts().size()).isBetween(most - 1, most);
    double speed = Math.hypot(vx, vy);
    assertThat(Math.hypot(world.vx(0), world.vy(0))).isCloseTo(speed, within(1e-13));
    // 3 distances of way: in to the tip, but for the radius, and back out.
    assertThat(Math.hypot(world.x(0), world.y(0))).isGreaterThan(distance);
  }

  /** Infinitely many impacts, each of which leaves less to be done: it ends between two lines. */
  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.5, 0.9})
  void comesToRestInAWedge(double e) {
    SceneBuilder scene = Scene.builder().line(0, 0, 100, 1).restitution(e);
    scene.line(0, 0, 100, -1).restitution(e).circle(50, 0, 0.1, -1, 0.01);
    World world = new World(scene.build());
    List<Impact> hits = Run.finish(world, 1e6, Run.WORK);
    assertThat(hits.get(hits.size() - 1).outcome()).isEqualTo(Outcome.JAMMED);
    assertThat(Math.hypot(world.vx(0), world.vy(0))).isZero();
    // It touches both lines, up to 64 ulps.
    double gap = world.x(0) / Math.hypot(100, 1) - 0.1;
    assertThat(gap).isCloseTo(0, within(64 * Math.ulp(10.0)));
  }
}
