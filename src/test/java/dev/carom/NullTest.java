// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.io.InputStream;
import java.io.OutputStream;
import java.io.Reader;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A null is refused by each call, whatever is there, by a NullPointerException that names the
 * argument.
 */
class NullTest {

  private static final Circle CIRCLE = new Circle(1, 2, 3);
  private static final Line LINE = new Line(1, 2, 3, 4);
  private static final Vec2 V = new Vec2(1, 2);
  private static final SweptSphere SPHERE = new SweptSphere(1, 2, 3, 1, 0, 0, 0);
  private static final SweptCircle MOVING = new SweptCircle(CIRCLE, V);
  private static final Scene EMPTY = Scene.builder().build();
  private static final Resolver RESOLVER = EMPTY.resolver();
  private static final World WORLD = new World(EMPTY);
  private static final Impact HIT =
      new SweptCircle(CIRCLE, new Vec2(5, 5)).cast(new Line(9, 9, 20, 20), 9).orElseThrow();
  private static final World BOX = new World(Scene.builder().bounds(0, 0, 1, 1).build());

  static Stream<Arguments> calls() {
    return Stream.of(questions(), worlds(), things()).flatMap(List::stream);
  }

  private static List<Arguments> questions() {
    return List.of(
        call("circle", () -> new SweptCircle(null, V)),
        call("velocity", () -> new SweptCircle(CIRCLE, null)),
        call("obstacle", () -> MOVING.cast((Obstacle) null, 1)),
        call("other", () -> MOVING.cast((SweptCircle) null, 1)),
        call("line", () -> MOVING.cast(null, V, 1)),
        call("lineVelocity", () -> MOVING.cast(LINE, null, 1)),
        call("other", () -> MOVING.timeToCircle(null, 1)),
        call("other", () -> CIRCLE.overlaps(null)),
        call("other", () -> CIRCLE.separation(null)),
        call("other", () -> SPHERE.timeToSphere(null, 1)),
        call("other", () -> SPHERE.overlaps(null)),
        call("first", () -> SweptSphere.respond(null, 1, SPHERE, 1, 1, new double[6])),
        call("second", () -> SweptSphere.respond(SPHERE, 1, null, 1, 1, new double[6])),
        call("velocities", () -> SweptSphere.respond(SPHERE, 1, SPHERE, 1, 1, null)),
        call("obstacles", () -> Resolver.of(null)),
        call("obstacles[0]", () -> Resolver.of(Collections.<Obstacle>singletonList(null))),
        call("velocities", () -> Resolver.respond(0, 0, 1, 1, 1, 1, 1, null)),
        call("normal", () -> V.reflect(null, 1)),
        call("circle", () -> RESOLVER.cast((SweptCircle) null, 1)),
        call("circle", () -> RESOLVER.trace(null, 1, 1, 1)),
        call("casts", () -> RESOLVER.cast((Casts) null, 1)),
        call("filter", () -> RESOLVER.withFilter(null)),
        call("kinds", () -> RESOLVER.nearest(1, 2, (Kind[]) null)),
        call("kinds[1]", () -> RESOLVER.nearest(1, 2, Kind.LINE, null)),
        call("disk", () -> RESOLVER.overlapping(Kind.LINE, (Circle) null)),
        call("box", () -> RESOLVER.overlapping(Kind.LINE, (Bounds) null)));
  }

  private static List<Arguments> worlds() {
    return List.of(
        call("scene", () -> new World(null)),
        call("kind", () -> HIT.involves(null, 0)),
        call("kind", () -> WORLD.contains(null, 0)),
        call("kind", () -> WORLD.idLimit(null)),
        call("kind", () -> WORLD.ids(null)),
        call("circle", () -> WORLD.cast((SweptCircle) null, 1)),
        call("circle", () -> WORLD.trace(null, 1, 1, 1)),
        call("filter", () -> WORLD.withFilter(null)),
        call("kind", () -> WORLD.overlapping(null, CIRCLE)),
        call("kind", () -> WORLD.overlapping(null, new Bounds(0, 0, 1, 1))),
        call("disk", () -> WORLD.overlapping(Kind.LINE, (Circle) null)),
        call("box", () -> WORLD.overlapping(Kind.CIRCLE, (Bounds) null)),
        call("kind", () -> EMPTY.traits(null, 0)),
        call("kind", () -> WORLD.traits(null, 0)),
        call("kind", () -> WORLD.setTraits(null, 0, Traits.DEFAULT)),
        call("traits", () -> BOX.setTraits(Kind.WALL, 0, null)),
        call("response", () -> Traits.DEFAULT.withResponse(null)),
        call("kind", () -> WORLD.remove(null, 0)),
        call("snapshot", () -> WORLD.restore(null)));
  }

  private static List<Arguments> things() {
    return List.of(
        call("center", () -> new Circle(null, 1)),
        call("start", () -> new Line(null, V)),
        call("end", () -> new Line(V, null)),
        call("p", () -> LINE.closestPoint(null)),
        call("response", () -> Scene.builder().response(null)),
        call("path", () -> Scene.read((Path) null)),
        call("in", () -> Scene.read((Reader) null, "name")),
        call("name", () -> Scene.read(new StringReader(""), null)),
        call("path", () -> EMPTY.write((Path) null)),
        call("out", () -> EMPTY.write((Appendable) null)),
        call("in", () -> Snapshot.read((InputStream) null)),
        call("out", () -> WORLD.snapshot().write((OutputStream) null)));
  }

  private static Arguments call(String argument, ThrowingCallable call) {
    return Arguments.of(argument, call);
  }

  @ParameterizedTest
  @MethodSource("calls")
  void isRefusedByName(String argument, ThrowingCallable call) {
    assertThatNullPointerException().isThrownBy(call).withMessage(argument + " is null");
  }
}
