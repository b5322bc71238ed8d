// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.StringReader;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Joined lines with one id: polylines, and solid polygons that keep circles out. */
class OutlineTest {

  private static final Outline BRICK = Outline.rectangle(4, 0, 6, 4);

  private static final Outline BUCKET = Outline.polyline(10, 5, 10, 1, 14, 1, 14, 5);

  private static Impact first(World world, double until) {
    assertThat(world.advanceToImpact(until)).isTrue();
    return world.impacts().get(0);
  }

  // The record.

  @Test
  void hasSides() {
    assertThat(BRICK.side(3)).isEqualTo(new Line(4, 4, 4, 0));
    assertThat(BUCKET.side(2)).isEqualTo(new Line(14, 1, 14, 5));
    assertThatThrownBy(() -> BUCKET.side(3))
        .isInstanceOf(IndexOutOfBoundsException.class)
        .hasMessage("side is 3: expected 0 to 2");
    assertThat(BRICK).isEqualTo(Outline.polygon(4, 0, 6, 0, 6, 4, 4, 4));
  }

  @Test
  void refusesWhatIsNoOutline() {
    refused(() -> Outline.polyline(1, 2), "points is 1 of them: expected at least 2");
    refused(
        () -> Outline.polygon(1, 2, 3, 4),
        "points is 2 of them: expected at least 3, as it is solid");
    refused(() -> Outline.polyline(1, 2, 3), "xy is 3 numbers: expected an even number");
    refused(() -> Outline.polyline(1, 2, Double.NaN, 3), "xy[2] is NaN: expected a finite");
    refused(() -> Outline.polyline(1, 2, 1, 2), "points[1] is (1.0, 2.0): expected another point");
    refused(() -> Outline.polygon(0, 0, 1, 0, 1, 1, 0, 0), "points[0] is (0.0, 0.0): expected");
    refused(() -> Outline.polygon(0, 0, 4, 4, 4, 0, 0, 4), "points is such that side 0 and side 2");
    refused(() -> Outline.polygon(0, 0, 4, 0, 2, 0), "points is such that side ");
    refused(() -> Outline.polygon(0, 0, 8, 0, 8, 4, 4, 0, 0, 4), "points is such that side 0 and");
    refused(() -> Outline.rectangle(1, 0, 1, 2), "xmax is 1.0: expected more than xmin");
  }

  private static void refused(Runnable call, String start) {
    assertThatIllegalArgumentException().isThrownBy(call::run).withMessageStartingWith(start);
  }

  // Scenes and files.

  @Test
  void isOneThingOfAScene() {
    Scene scene =
        Scene.builder()
            .line(0, 0, 1, 0)
            .outline(BRICK)
            .restitution(0.5)
            .outline(BUCKET)
            .velocity(1, 0)
            .line(0, 9, 1, 9)
            .build();
    assertThat(scene.count(Kind.LINE)).isEqualTo(4);
    assertThat(scene.shape(Kind.LINE, 1)).isEqualTo(BRICK);
    assertThat(scene.shape(Kind.LINE, 2)).isEqualTo(BUCKET);
    assertThat(scene.shape(Kind.LINE, 3)).isEqualTo(new Line(0, 9, 1, 9));
    assertThat(scene.traits(Kind.LINE, 1).restitution()).isEqualTo(0.5);
    assertThat(scene.velocity(Kind.LINE, 2)).isEqualTo(new Vec2(1, 0));
    assertThat(scene.toBuilder().build()).isEqualTo(scene);
  }

  @Test
  void isARowOfAFile() throws IOException {
    Scene scene =
        Scene.builder()
            .outline(BUCKET)
            .oneWay()
            .outline(BRICK)
            .response(Response.HALT)
            .velocity(1, 2)
            .build();
    StringBuilder text = new StringBuilder();
    scene.write(text);
    assertThat(text)
        .hasToString(
            """
            outline,10.0,5.0,10.0,1.0,14.0,1.0,14.0,5.0,oneway=1
            outline,4.0,0.0,6.0,0.0,6.0,4.0,4.0,4.0,solid=1,vx=1.0,vy=2.0,response=halt
            """);
    assertThat(Scene.read(new StringReader(text.toString()), "text")).isEqualTo(scene);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "outline,1,2,3|1:14: y is missing: expected outline,x,y,x,y,...",
        "outline,1,2|1:12: x is missing: expected outline,x,y,x,y,...",
        "outline,1,2,x,4|1:13: x is \"x\": expected a finite number",
        "outline,0,0,4,4,4,0,0,4,solid=1|1:9: points is such that side 0 and side 2 meet: expected a"
            + " polygon that neither crosses nor touches itself",
        "outline,0,0,4,4,4,4|1:17: points[2] is (4.0, 4.0): expected another point than the one"
            + " before",
        "outline,0,0,4,0,0,3,solid=1,oneway=1|1:29: oneway is true: expected false: a solid outline"
            + " keeps circles out on all sides",
        "line,0,0,4,0,solid=1|1:14: key \"solid\" is unknown: expected restitution=NUMBER,"
            + " response=WORD, category=INTEGER, mask=INTEGER, vx=NUMBER, vy=NUMBER or oneway=0|1",
      })
  void aBadRowIsRefused(String rowAndMessage) {
    String[] parts = rowAndMessage.split("\\|", 2);
    assertThatThrownBy(() -> Scene.read(new StringReader(parts[0]), "s"))
        .isInstanceOf(SceneFormatException.class)
        .hasMessage("s:" + parts[1]);
  }

  @Test
  void warnsOfACircleInside() {
    Scene scene =
        Scene.builder().outline(BRICK).circle(5, 2, 0.5, 0, 0).circle(3.75, 2, 0.5, 0, 0).build();
    assertThat(scene.warnings())
        .containsExactly(
            new Warning(0, Kind.LINE, 0, -1, 0.5), new Warning(1, Kind.LINE, 0, 0.25, 0.5));
  }

  // Impacts.

  @Test
  void theLogNamesTheSide() {
    Scene scene = Scene.builder().line(0, 9, 1, 9).outline(BRICK).circle(1, 1, 1, 1, 0).build();
    World world = new World(scene);
    Impact hit = first(world, 10);
    assertThat(List.of(hit.kind(), hit.id(), hit.part(), hit.feature()))
        .isEqualTo(List.of(Kind.LINE, 1, 3, Feature.SIDE));
    assertThat(hit.time()).isEqualTo(2);
    assertThat(world.cast(new SweptCircle(5, 9, 1, 0, -1), 9).orElseThrow().part()).isEqualTo(2);
    Impact alone = new SweptCircle(9, 2, 1, -1, 0).cast(BRICK, 9).orElseThrow();
    assertThat(List.of(alone.part(), alone.id(), alone.time())).isEqualTo(List.of(1, -1, 2.0));
    Casts casts = new Casts();
    casts.add(5, -9, 1, 0, 1);
    world.cast(casts, 20);
    assertThat(List.of(casts.id(0), casts.part(0))).isEqualTo(List.of(1, 0));
  }

  @Test
  void aVertexIsTheStartOfTheSideThatBeginsThere() {
    for (Outline outline : List.of(BRICK, Outline.polyline(4, 4, 4, 0, 6, 0))) {
      Impact hit = new SweptCircle(3, -3, 1, 1, 2).cast(outline, 9).orElseThrow();
      assertThat(hit.feature()).isEqualTo(Feature.START);
      assertThat(outline.side(hit.part()).start()).isEqualTo(new Vec2(4, 0));
    }
    Outline open = Outline.polyline(4, 4, 4, 0, 6, 0);
    Impact last = new SweptCircle(6, -3, 1, 0.25, 2).cast(open, 9).orElseThrow();
    assertThat(List.of(last.feature(), last.part())).isEqualTo(List.of(Feature.END, 1));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -10})
  void aCircleInsideMayLeave(double gravity) {
    for (Outline shape : List.of(BRICK, Outline.polygon(4, 0, 4, 4, 6, 4, 6, 0))) {
      Scene scene =
          Scene.builder()
              .gravity(0, gravity)
              .outline(shape)
              .circle(5, 2, 0.5, 1, 0.125)
              .circle(4.25, 2, 0.5, -3, 0)
              .collide(false)
              .build();
      World world = new World(scene);
      world.advanceTo(4);
      assertThat(world.impacts().size()).isZero();
    }
  }

  /** A spike has vertices whose normal points away from one of their sides. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-3})
  void aSpikeIsHitAtItsTip(double gravity) {
    Outline spike = Outline.polygon(0, 0, 10, 0.1, 0, 0.2);
    Scene scene =
        Scene.builder().gravity(0, -gravity).outline(spike).circle(9.9, 2, 1, 0.05, -1).build();
    Impact hit = first(new World(scene), 9);
    assertThat(hit.time()).isCloseTo(0.9, within(0.01));
    scene =
        Scene.builder()
            .gravity(0, -gravity)
            .outline(spike)
            .circle(10.5, 1.05, 1, -0.125, -0.0625)
            .build();
    Impact tip = first(new World(scene), 9);
    assertThat(tip.x()).isCloseTo(10, within(1e-9));
    assertThat(tip.y()).isCloseTo(0.1, within(1e-9));
  }

  @ParameterizedTest
  @CsvSource({
    "true, 0, 1", "true, 0, 0.5", "true, 0, 0", "true, -5, 1", "true, -5, 0.5", "true, -5, 0",
    "false, 0, 1", "false, 0, 0.5", "false, 0, 0", "false, -5, 1", "false, -5, 0.5", "false, -5, 0"
  })
  void aRacketPressesABallOnAWallAndLeavesItOutside(boolean collide, double gravity, double e) {
    Scene scene =
        Scene.builder()
            .bounds(0, 0, 20, 10)
            .gravity(0, gravity)
            .outline(Outline.rectangle(10, 0.5, 12, 9.5))
            .circle(5, 5, 1, 0, 0)
            .restitution(e)
            .collide(collide)
            .build();
    World world = new World(scene);
    for (double x : new double[] {0.5, 14, 0.25, 15}) {
      world.moveTo(Kind.LINE, 0, x, 0.5, world.now() + 3);
      world.step(3);
    }
    world.step(1);
    Circle ball = (Circle) world.shape(Kind.CIRCLE, 0);
    assertThat(ball.overlaps(world.shape(Kind.LINE, 0))).isFalse();
    assertThat(ball.x()).isLessThan(15);
  }

  @Test
  void aSensorReportsACircleOnce() {
    Scene scene =
        Scene.builder()
            .outline(BRICK)
            .response(Response.SENSOR)
            .outline(BUCKET)
            .response(Response.SENSOR)
            .circle(1, 2, 0.5, 1, 0)
            .circle(3, -1, 0.5, 1, 1)
            .build();
    World world = new World(scene);
    world.advanceTo(20);
    assertThat(world.impacts())
        .filteredOn(it -> it.circle() == 0)
        .extracting(Impact::id)
        .containsExactly(0, 1, 1);
    assertThat(world.impacts()).filteredOn(it -> it.circle() == 1 && it.id() == 0).hasSize(1);
  }

  @Test
  void aBallRestsInABucketAndOnABrick() {
    Scene scene =
        Scene.builder()
            .gravity(0, -10)
            .outline(BRICK)
            .outline(BUCKET)
            .circle(5, 8, 0.5, 0, 0)
            .restitution(0.5)
            .circle(12, 8, 0.5, 0.5, 0)
            .restitution(0.5)
            .build();
    World world = new World(scene);
    world.advanceTo(30);
    assertThat(world.isResting(0)).isTrue();
    assertThat(world.y(0)).isCloseTo(4.5, within(1e-9));
    assertThat(world.contacts(0)).containsExactly(new Contact(Kind.LINE, 0, 2, 0, 1));
    assertThat(world.y(1)).isCloseTo(1.5, within(1e-9));
    assertThat(world.contacts(1)).anyMatch(it -> it.id() == 1 && it.part() == 1 && it.ny() > 0.9);
    world.remove(Kind.LINE, 0);
    world.advanceTo(31);
    assertThat(world.y(0)).isLessThan(4);
  }

  /** A ball whose centre is in a polygon is not in contact with its inner corner. */
  @Test
  void insideNothingIsInContact() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(-4, -0.04, 4, -0.04)
                .circle(1.2, 0.5, 0.54, 0, 0)
                .restitution(0)
                .build());
    world.advanceTo(1);
    int corner =
        world.addOutline(Outline.polygon(-5, -5, 5, -5, 5, 1, 1, 1, 1, 5, -5, 5), Traits.DEFAULT);
    world.advanceTo(2);
    assertThat(world.overlapping(Kind.LINE, new Circle(1.2, 0.5, 0.539))).contains(corner);
    assertThat(world.contacts(0)).extracting(Contact::id).containsExactly(0);
  }

  // Edits.

  @Test
  void isMovedAndRemovedAsOne() {
    World world = new World(Scene.builder().circle(0, 0, 1, 0, 0).build());
    int id = world.addOutline(BRICK, Traits.DEFAULT.withRestitution(0.5));
    int line = world.addLine(20, 0, 20, 5, Traits.DEFAULT);
    assertThat(List.of(id, line)).isEqualTo(List.of(0, 1));
    assertThat(world.ids(Kind.LINE)).containsExactly(0, 1);
    world.moveTo(Kind.LINE, 0, 5, 0.1, 1);
    world.step(0.5);
    assertThat(world.velocity(Kind.LINE, 0)).isEqualTo(new Vec2(1, 0.1));
    world.step(0.5);
    assertThat(world.shape(Kind.LINE, 0))
        .isEqualTo(Outline.polygon(5, 0.1, 7, 0.1, 7, 4.1, 5, 4.1));
    world.setShape(Kind.LINE, 0, Outline.polygon(5, 0, 5, 9, 7, 9, 7, 0));
    world.setTraits(Kind.LINE, 0, Traits.DEFAULT.withResponse(Response.HALT));
    assertThat(world.traits(Kind.LINE, 0).response()).isEqualTo(Response.HALT);
    Impact hit = world.cast(new SweptCircle(0, 8, 1, 1, 0), 9).orElseThrow();
    assertThat(List.of(hit.time(), hit.id(), hit.part())).isEqualTo(List.of(4.0, 0, 0));
    world.remove(Kind.LINE, 0);
    assertThat(world.contains(Kind.LINE, 0)).isFalse();
    assertThat(world.ids(Kind.LINE)).containsExactly(1);
    assertThat(world.cast(new SweptCircle(0, 3, 1, 1, 0), 99).orElseThrow().id()).isEqualTo(1);
  }

  @Test
  void aRefusedEditChangesNothing() {
    World world = new World(Scene.builder().outline(BRICK).circle(0, 0, 1, 0, 0).build());
    Snapshot before = world.snapshot();
    refused(
        () -> world.setShape(Kind.LINE, 0, BUCKET),
        "shape of line 0 is an open outline of 3 sides: expected a solid outline of 4 sides");
    refused(
        () -> world.setShape(Kind.LINE, 0, new Line(0, 0, 1, 1)),
        "shape of line 0 is Line[ax=0.0, ay=0.0, bx=1.0, by=1.0]: expected an Outline");
    refused(() -> world.setShape(Kind.LINE, 0, new Circle(0, 0, 1)), "shape of line 0 is ");
    refused(() -> world.line(0), "line 0 is an outline of 4 sides: expected a single line");
    refused(
        () -> world.setTraits(Kind.LINE, 0, Traits.DEFAULT.withOneWay(true)),
        "line 0: oneWay is true: expected false");
    refused(
        () -> world.addOutline(BRICK, Traits.DEFAULT.withOneWay(true)),
        "line 1: oneWay is true: expected false");
    refused(
        () -> world.addOutline(Outline.polyline(0, 0, 0x1p60, 1), Traits.DEFAULT),
        "line 1: points[1].x is ");
    refused(
        () -> Scene.builder().outline(BRICK).oneWay(), "line 0: oneway is true: expected false");
    assertThat(world.snapshot()).isEqualTo(before);
  }

  /** Its points would round to others: then it is shown as its first side. */
  @Test
  void farAwayItIsShownAsALine() {
    World world = new World(Scene.builder().outline(BRICK).velocity(1e300, 0).build());
    assertThat(world.shape(Kind.LINE, 0)).isInstanceOf(Outline.class);
    world.step(1);
    assertThat(world.shape(Kind.LINE, 0)).isEqualTo(new Line(1e300, 0, 1e300, 0));
  }

  // Questions.

  @Test
  void questionsSeeOneThing() {
    Scene scene = Scene.builder().line(0, -9, 20, -9).outline(BRICK).outline(BUCKET).build();
    Resolver room = scene.resolver();
    assertThat(room.overlapping(Kind.LINE, new Circle(5, 2, 0.125))).containsExactly(1);
    assertThat(room.overlapping(Kind.LINE, new Circle(12, 3, 0.125))).isEmpty();
    assertThat(room.overlapping(Kind.LINE, new Bounds(4.5, 1, 5, 2))).containsExactly(1);
    assertThat(room.overlapping(Kind.LINE, new Bounds(3, -10, 11, 6))).containsExactly(0, 1, 2);
    assertThat(room.nearest(5, 2, Kind.LINE)).contains(new Nearest(Kind.LINE, 1, 0, 5, 2));
    assertThat(room.nearest(7, 2)).contains(new Nearest(Kind.LINE, 1, 1, 6, 2));
    assertThat(room.nearest(12, 2)).contains(new Nearest(Kind.LINE, 2, 1, 12, 1));
    assertThat(new Circle(5, 2, 0.5).overlaps(BRICK)).isTrue();
    assertThat(new Circle(12, 3, 0.5).overlaps(BUCKET)).isFalse();
    assertThat(room.cast(new SweptCircle(5, 2, 0.5, 1, 0), 4)).isEmpty();
  }

  @Test
  void aTraceBouncesOffIt() {
    World world = new World(Scene.builder().outline(BRICK).circle(0, 2, 1, 0, 0).build());
    Trajectory path = world.trace(0, 1, 0, 9, 3);
    assertThat(path.impacts()).hasSize(1);
    assertThat(path.impacts().get(0).part()).isEqualTo(3);
  }

  @Test
  void separationLeadsOut() {
    Random random = new Random(5);
    Outline notched = Outline.polygon(0, 0, 6, 0, 6, 6, 3, 2, 0, 6);
    for (Outline outline :
        List.of(BRICK, BUCKET, notched, Outline.polyline(0, 0, 3, 0, 3, 3, 0, 3))) {
      for (int k = 0; k < 500; k++) {
        Circle c =
            new Circle(
                random.nextDouble() * 8, random.nextDouble() * 8, 0.25 + random.nextDouble());
        Vec2 out = c.separation(outline);
        Circle free = new Circle(c.x() + out.x(), c.y() + out.y(), c.radius());
        assertThat(free.overlaps(outline)).isFalse();
        assertThat(out.equals(Vec2.ZERO)).isEqualTo(!c.overlaps(outline));
        for (int way = 0; way < 64; way++) {
          double angle = way * Math.PI / 32;
          double length = out.length() * 0.999;
          Circle other =
              new Circle(
                  c.x() + length * Math.cos(angle), c.y() + length * Math.sin(angle), c.radius());
          assertThat(out.equals(Vec2.ZERO) || other.overlaps(outline)).isTrue();
        }
      }
    }
  }

  // States.

  @ParameterizedTest
  @ValueSource(doubles = {0, -1})
  void aSavedWorldGoesOnAlike(double gravity) throws IOException {
    Scene scene =
        Scene.builder()
            .gravity(0, gravity)
            .bounds(0, 0, 30, 30)
            .outline(BRICK)
            .velocity(0.5, 0.25)
            .outline(BUCKET)
            .circle(2, 20, 1, 3, 1)
            .circle(20, 20, 1, -3, 1)
            .build();
    World world = new World(scene);
    world.record(100);
    world.advanceTo(7);
    world.remove(Kind.LINE, 1);
    int added = world.addOutline(Outline.polygon(20, 2, 25, 2, 22, 6), Traits.DEFAULT);
    world.moveTo(Kind.LINE, 0, 9, 9, 20);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    world.snapshot().write(out);
    World other = new World(scene);
    other.restore(Snapshot.read(new ByteArrayInputStream(out.toByteArray())));
    assertThat(other.shape(Kind.LINE, added)).isEqualTo(world.shape(Kind.LINE, added));
    world.advanceTo(40);
    other.advanceTo(40);
    assertThat(other.snapshot()).isEqualTo(world.snapshot());
  }

  @Test
  void aTimelineKnowsItAsItWas() {
    World world =
        new World(
            Scene.builder().outline(BRICK).circle(0, 2, 1, 1, 0).circle(9, 9, 1, 0, 0).build());
    Timeline past = world.record(100);
    world.advanceTo(5);
    world.remove(Kind.LINE, 0);
    world.addOutline(BUCKET, Traits.DEFAULT);
    world.advanceTo(10);
    assertThat(past.shape(Kind.LINE, 0, 4)).isEqualTo(BRICK);
    assertThat(past.contains(Kind.LINE, 0, 6)).isFalse();
    assertThat(past.shape(Kind.LINE, 1, 7)).isEqualTo(BUCKET);
    Snapshot then = past.snapshot(4);
    World again = new World(world.scene());
    again.advanceTo(4);
    assertThat(then).isEqualTo(again.snapshot());
    again.restore(past.snapshot(8));
    assertThat(again.shape(Kind.LINE, 1)).isEqualTo(BUCKET);
  }

  // Random polygons are never entered.

  private static Outline star(Random random, double x, double y) {
    int n = 3 + random.nextInt(9);
    boolean back = random.nextBoolean();
    double[] xy = new double[2 * n];
    for (int i = 0; i < n; i++) {
      double angle = 2 * Math.PI * (i + 0.8 * random.nextDouble()) / n * (back ? -1 : 1);
      double radius = 0.3 + 3 * random.nextDouble();
      xy[2 * i] = x + radius * Math.cos(angle);
      xy[2 * i + 1] = y + radius * Math.sin(angle);
    }
    return Outline.polygon(xy);
  }

  private static Scene stars(long seed, double gravity, boolean moving) {
    Random random = new Random(seed);
    SceneBuilder scene = Scene.builder().bounds(0, 0, 40, 40).gravity(0, gravity);
    for (int k = 0; k < 9; k++) {
      scene.outline(star(random, 7 + 13 * (k % 3), 7 + 13 * (k / 3)));
      if (moving && k % 2 == 0) {
        scene.velocity(random.nextDouble() - 0.5, random.nextDouble() - 0.5);
      }
    }
    for (int k = 0; k < 8; k++) {
      scene
          .circle(
              1 + 12.5 * (k % 4),
              k < 4 ? 1 : 39,
              0.1 + 0.8 * random.nextDouble(),
              3 * random.nextDouble() - 1.5,
              3 * random.nextDouble() - 1.5)
          .restitution(gravity == 0 ? 1 : 0.9);
    }
    return scene.collide(seed % 2 == 0).build();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -0.5})
  void noCircleComesIn(double gravity) {
    for (long seed = 0; seed < 40; seed++) {
      Scene scene = stars(seed, gravity, false);
      World world = new World(scene);
      for (int frame = 0; frame < 60; frame++) {
        world.step(1);
        for (int id : world.ids(Kind.CIRCLE)) {
          Circle circle = new Circle(world.x(id), world.y(id), world.radius(id) * (1 - 1e-9));
          for (int line : world.ids(Kind.LINE)) {
            assertThat(circle.overlaps(world.shape(Kind.LINE, line)))
                .as("seed %s frame %s circle %s outline %s", seed, frame, id, line)
                .isFalse();
          }
        }
      }
    }
  }

  /** The same lines, two-sided and not joined, stop circles that are outside in the same places. */
  @ParameterizedTest
  @ValueSource(doubles = {0, -0.5})
  void outsideItMovesCirclesAsItsLinesDo(double gravity) {
    for (long seed = 1; seed < 40; seed += 2) {
      Scene scene = stars(seed, gravity, false);
      SceneBuilder lines = Scene.builder().bounds(0, 0, 40, 40).gravity(0, gravity).collide(false);
      for (int k = 0; k < scene.count(Kind.LINE); k++) {
        Outline outline = (Outline) scene.shape(Kind.LINE, k);
        for (int i = 0; i < outline.points().size(); i++) {
          Line side = outline.side(i);
          lines.line(side.ax(), side.ay(), side.bx(), side.by());
        }
      }
      for (int k = 0; k < scene.count(Kind.CIRCLE); k++) {
        Circle c = (Circle) scene.shape(Kind.CIRCLE, k);
        Vec2 v = scene.velocity(Kind.CIRCLE, k);
        lines.circle(c.x(), c.y(), c.radius(), v.x(), v.y());
        lines.restitution(scene.traits(Kind.CIRCLE, k).restitution());
      }
      assertThat(places(new World(scene), 60)).isEqualTo(places(new World(lines.build()), 60));
    }
  }

  private static double[] places(World world, double until) {
    world.advanceTo(until);
    return IntStream.of(world.ids(Kind.CIRCLE))
        .boxed()
        .flatMapToDouble(id -> DoubleStream.of(world.x(id), world.y(id)))
        .toArray();
  }

  /** Mirrored, all signs and orders of vertices differ, and no bit else. */
  @ParameterizedTest
  @ValueSource(doubles = {0, -0.5})
  void mirrorsAreEqual(double gravity) {
    UnaryOperator<Scene> mirror =
        scene -> {
          SceneBuilder b = Scene.builder().bounds(-40, 0, 0, 40).gravity(0, gravity).collide(false);
          for (int k = 0; k < scene.count(Kind.LINE); k++) {
            Outline outline = (Outline) scene.shape(Kind.LINE, k);
            Vec2 u = scene.velocity(Kind.LINE, k);
            b.outline(
                new Outline(
                    outline.points().stream().map(p -> new Vec2(-p.x(), p.y())).toList(), true));
            b.velocity(-u.x(), u.y());
          }
          for (int k = 0; k < scene.count(Kind.CIRCLE); k++) {
            Circle c = (Circle) scene.shape(Kind.CIRCLE, k);
            Vec2 v = scene.velocity(Kind.CIRCLE, k);
            b.circle(-c.x(), c.y(), c.radius(), -v.x(), v.y());
            b.restitution(scene.traits(Kind.CIRCLE, k).restitution());
          }
          return b.build();
        };
    for (long seed = 1; seed < 20; seed += 2) {
      Scene scene = stars(seed, gravity, true);
      double[] here = places(new World(scene), 20);
      double[] there = places(new World(mirror.apply(scene)), 20);
      for (int k = 0; k < here.length; k += 2) {
        assertThat(-there[k]).as("seed %s", seed).isEqualTo(here[k]);
        assertThat(there[k + 1]).isEqualTo(here[k + 1]);
      }
    }
  }
}
