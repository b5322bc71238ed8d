// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.Reader;
import java.io.StringReader;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * No public method or constructor takes or returns null. All of them are found by reflection, so a
 * new one is asked, too. The message names the parameter.
 */
class NoNullTest {

  private static final Class<?>[] REFUSALS = {
    IllegalArgumentException.class,
    IllegalStateException.class,
    IndexOutOfBoundsException.class,
    IOException.class
  };

  private static final Circle CIRCLE = new Circle(1, 2, 3);

  /** An argument of each type; new for each call. */
  private static final Map<Class<?>, Supplier<?>> SAMPLES =
      Map.ofEntries(
          sample(double.class, () -> 1.0),
          sample(int.class, () -> 0),
          sample(long.class, () -> 1L),
          sample(boolean.class, () -> true),
          sample(String.class, () -> "name"),
          sample(double[].class, () -> new double[] {1, 2, 3, 4, 5, 9}),
          sample(List.class, () -> List.of(CIRCLE)),
          sample(Path.class, () -> Path.of("no-such-file")),
          sample(Reader.class, () -> new StringReader("peg,1,2,3")),
          sample(Appendable.class, StringBuilder::new),
          sample(InputStream.class, () -> new ByteArrayInputStream(new byte[0])),
          sample(OutputStream.class, ByteArrayOutputStream::new),
          sample(Vec2.class, () -> new Vec2(1, 2)),
          sample(SweptCircle.class, () -> new SweptCircle(1, 2, 3, 4, 5)),
          sample(SweptSphere.class, () -> new SweptSphere(1, 2, 3, 4, 5, 6, 7)),
          sample(Nearest.class, () -> new Nearest(Kind.PEG, 0, 1, 2, 3)),
          sample(Contact.class, () -> new Contact(Kind.PEG, 0, 0, 0, 1)),
          sample(Obstacle.class, () -> CIRCLE),
          sample(Circle.class, () -> CIRCLE),
          sample(Line.class, () -> new Line(1, 2, 3, 4)),
          sample(Outline.class, () -> Outline.polyline(1, 2, 3, 4, 5, 9)),
          sample(Bounds.class, () -> new Bounds(1, 2, 3, 4)),
          sample(Filter.class, () -> Filter.DEFAULT),
          sample(Traits.class, () -> Traits.DEFAULT),
          sample(Kind.class, () -> Kind.CIRCLE),
          sample(Kind[].class, () -> new Kind[] {Kind.PEG}),
          sample(Feature.class, () -> Feature.SIDE),
          sample(Response.class, () -> Response.HALT),
          sample(Outcome.class, () -> Outcome.BOUNCED),
          sample(SceneBuilder.class, () -> Scene.builder().circle(1, 2, 3, 4, 5)),
          sample(Scene.class, () -> world().scene()),
          sample(SceneFormatException.class, NoNullTest::mistake),
          sample(Warning.class, () -> new Warning(0, Kind.WALL, 0, 1, 2)),
          sample(Resolver.class, () -> world().scene().resolver()),
          sample(Casts.class, Casts::new),
          sample(Trajectory.class, NoNullTest::trajectory),
          sample(Impact.class, () -> trajectory().impacts().get(0)),
          sample(World.class, NoNullTest::world),
          sample(ImpactLog.class, () -> world().impacts()),
          sample(Snapshot.class, () -> world().snapshot()),
          sample(Timeline.class, () -> world().record(1)),
          sample(Uncertainty.class, () -> world().uncertainty(1)));

  private static final List<Vec2> POINTS = List.of(new Vec2(1, 2), new Vec2(3, 4));

  private static Map.Entry<Class<?>, Supplier<?>> sample(Class<?> type, Supplier<?> value) {
    return Map.entry(type, value);
  }

  /** A world with something of each kind, and with rows in its log. */
  private static World world() {
    World world =
        new World(
            Scene.builder()
                .bounds(0, 0, 100, 100)
                .line(50, 0, 50, 50)
                .peg(90, 90, 2)
                .circle(20, 20, 5, 30, 1)
                .build());
    world.step(1);
    return world;
  }

  private static Throwable mistake() {
    return catchThrowable(() -> Scene.read(new StringReader("what"), "name"));
  }

  private static Trajectory trajectory() {
    return world()
        .scene()
        .resolver()
        .trace(new SweptCircle(CIRCLE, new Vec2(9, 9)), 1, 99, Integer.MAX_VALUE);
  }

  private static Stream<Executable> all() throws Exception {
    List<Executable> all = new ArrayList<>();
    for (Class<?> type : PublicApiTest.classes(World.class)) {
      if (Modifier.isPublic(type.getModifiers())) {
        all.addAll(Arrays.asList(type.getConstructors()));
        Arrays.stream(type.getDeclaredMethods())
            .filter(m -> Modifier.isPublic(m.getModifiers()) && !m.isBridge())
            .filter(m -> !m.getName().equals("equals") && !m.getName().equals("valueOf"))
            .forEach(all::add);
      }
    }
    return all.stream();
  }

  static Stream<Arguments> references() throws Exception {
    return all()
        .flatMap(
            call ->
                Stream.iterate(0, i -> i < call.getParameterCount(), i -> i + 1)
                    .filter(i -> !call.getParameterTypes()[i].isPrimitive())
                    .map(i -> Arguments.of(call, i)));
  }

  static Stream<Method> answers() throws Exception {
    return all()
        .filter(call -> call instanceof Method)
        .map(call -> (Method) call)
        .filter(method -> !method.getReturnType().isPrimitive());
  }

  private static Object value(Class<?> type) {
    Supplier<?> sample = SAMPLES.get(type);
    assertThat(sample).as("a sample of %s", type).isNotNull();
    return sample.get();
  }

  private static Object[] arguments(Executable call) {
    return Arrays.stream(call.getGenericParameterTypes())
        .map(type -> type.getTypeName().endsWith("<dev.carom.Vec2>") ? POINTS : value(raw(type)))
        .toArray();
  }

  private static Class<?> raw(Type type) {
    return (Class<?>) (type instanceof ParameterizedType of ? of.getRawType() : type);
  }

  private static Object answer(Executable call, Object... arguments) throws Throwable {
    try {
      if (call instanceof Constructor<?> constructor) {
        return constructor.newInstance(arguments);
      }
      boolean isStatic = Modifier.isStatic(call.getModifiers());
      return ((Method) call).invoke(isStatic ? null : value(call.getDeclaringClass()), arguments);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }

  @ParameterizedTest
  @MethodSource("references")
  void nullIsRefused(Executable call, int parameter) {
    Object[] arguments = arguments(call);
    arguments[parameter] = null;

    assertThat(catchThrowable(() -> answer(call, arguments)))
        .isInstanceOf(NullPointerException.class)
        .hasMessage(call.getParameters()[parameter].getName() + " is null");
  }

  @Test
  void anElementIsRefusedByItsPlace() {
    assertThatNullPointerException()
        .isThrownBy(() -> Resolver.of(Collections.<Obstacle>singletonList(null)))
        .withMessage("obstacles[0] is null");
    assertThatNullPointerException()
        .isThrownBy(() -> world().nearest(1, 2, Kind.LINE, null))
        .withMessage("kinds[1] is null");
  }

  @ParameterizedTest
  @MethodSource("answers")
  void nullIsNoAnswer(Method call) {
    Object[] arguments = arguments(call);
    AtomicReference<Object> answer = new AtomicReference<>();
    Throwable refused = catchThrowable(() -> answer.set(answer(call, arguments)));

    if (refused == null) {
      assertThat(answer.get()).isNotNull();
    } else {
      assertThat(refused).as("the arguments do not fit").isInstanceOfAny(REFUSALS);
    }
  }
}
