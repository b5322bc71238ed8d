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
import org.junit.jupiter.params.provider.MethodSource;

/** A null is refused by each call, whatever is there, by a NullPointerException. */
class NullTest {

  private static final Circle CIRCLE = new Circle(1, 2, 3);
  private static final Line LINE = new Line(1, 2, 3, 4);
  private static final Vec2 V = new Vec2(1, 2);
  private static final Scene EMPTY = Scene.builder().build();
  private static final Resolver RESOLVER = Resolver.of(EMPTY);
  private static final World WORLD = new World(EMPTY);

  static Stream<ThrowingCallable> calls() {
    return Stream.of(questions(), worlds(), things()).flatMap(List::stream);
  }

  private static List<ThrowingCallable> questions() {
    return List.of(
        () -> SweptCircle.cast(null, V, LINE, 1),
        () -> SweptCircle.cast(CIRCLE, null, LINE, 1),
        () -> SweptCircle.cast(CIRCLE, V, null, 1),
        () -> SweptCircle.cast(CIRCLE, V, CIRCLE, null, 1),
        () -> SweptCircle.separation(null, CIRCLE),
        () -> SweptCircle.separation(CIRCLE, (Line) null),
        () -> SweptSphere.respond(0, 0, 0, 1, 1, 1, 1, 1, 1, null),
        () -> Resolver.of((Scene) null),
        () -> Resolver.of((List<Obstacle>) null),
        () -> Resolver.of(Collections.<Obstacle>singletonList(null)),
        () -> Resolver.respond(0, 0, 1, 1, 1, 1, 1, null),
        () -> Resolver.reflect(null, V, 1),
        () -> Resolver.reflect(V, null, 1),
        () -> RESOLVER.cast(null, V, 1),
        () -> RESOLVER.cast(CIRCLE, null, 1),
        () -> RESOLVER.trace(null, V, 1),
        () -> RESOLVER.trace(CIRCLE, null, 1),
        () -> RESOLVER.nearest(null),
        () -> RESOLVER.overlapping((Circle) null),
        () -> RESOLVER.overlapping((Bounds) null));
  }

  private static List<ThrowingCallable> worlds() {
    return List.of(
        () -> new World(null),
        () -> WORLD.contains(null, 0),
        () -> WORLD.idEnd(null),
        () -> WORLD.cast(null, V, 1),
        () -> WORLD.cast(CIRCLE, null, 1),
        () -> WORLD.trace(null, V, 1, 1, 1),
        () -> WORLD.trace(CIRCLE, null, 1, 1, 1),
        () -> WORLD.nearest(null, 1, 2),
        () -> WORLD.overlapping(null, CIRCLE),
        () -> WORLD.overlapping(null, new Bounds(0, 0, 1, 1)),
        () -> WORLD.overlapping(ObstacleKind.LINE, (Circle) null),
        () -> WORLD.overlapping(ObstacleKind.CIRCLE, (Bounds) null),
        () -> EMPTY.restitution(null, 0),
        () -> EMPTY.response(null, 0),
        () -> WORLD.restitution(null, 0),
        () -> WORLD.response(null, 0),
        () -> WORLD.setRestitution(null, 0, 1),
        () -> WORLD.setResponse(null, 0, Response.HALT),
        () -> WORLD.remove(null, 0),
        () -> WORLD.restore(null));
  }

  private static List<ThrowingCallable> things() {
    return List.of(
        () -> new Circle(null, 1),
        () -> new Line(null, V),
        () -> new Line(V, null),
        () -> LINE.closestPoint(null),
        () -> Scene.builder().response(null),
        () -> Scene.read((Path) null),
        () -> Scene.read((Reader) null, "name"),
        () -> Scene.read(new StringReader(""), null),
        () -> EMPTY.write((Path) null),
        () -> EMPTY.write((Appendable) null),
        () -> Snapshot.read((InputStream) null),
        () -> WORLD.snapshot().write((OutputStream) null));
  }

  @ParameterizedTest
  @MethodSource("calls")
  void isRefused(ThrowingCallable call) {
    assertThatNullPointerException().isThrownBy(call);
  }
}
