// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Reader;
import java.io.StringReader;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.Stream;

/** Calls of the public methods with good and bad arguments, each on a fresh object. */
public final class BadArguments {

  /** One call: its arguments, its answer, and what it threw, or null. */
  public record Call(List<Object> arguments, Object answer, Throwable thrown) {

    public boolean hasNull() {
      return arguments.stream()
          .anyMatch(one -> one == null || (one instanceof List<?> list && list.contains(null)));
    }
  }

  private static final Path CLASSES = Path.of("../src/target/classes/dev/carom");
  private static final int RANDOM_CALLS = 40;

  private static final Circle CIRCLE = new Circle(1, 2, 3);
  private static final Vec2 V = new Vec2(1, 2);
  private static final Line LINE = new Line(1, 2, 3, 4);
  private static final Bounds BOX = new Bounds(0, 0, 100, 100);

  private static final Object[] DOUBLES = {
    10.0,
    1.0,
    0.0,
    -1.0,
    1e-300,
    1e200,
    Double.NaN,
    Double.POSITIVE_INFINITY,
    Double.NEGATIVE_INFINITY,
    Double.MAX_VALUE,
    -Double.MAX_VALUE,
    Double.MIN_VALUE
  };
  private static final Outline BRICK = Outline.rectangle(40, 0, 60, 20);

  private static final Object[] INTS = {
    0, 1, 2, -1, 99, 1 << 28, 1 << 30, Integer.MAX_VALUE, Integer.MIN_VALUE
  };

  /** A folder of the test's own: some of the methods write. */
  private final Path folder;

  /** For each type of a parameter a good value, then others, null among them. */
  private final Map<Class<?>, Supplier<Object[]>> values =
      Map.ofEntries(
          Map.entry(double.class, () -> DOUBLES),
          Map.entry(int.class, () -> INTS),
          Map.entry(boolean.class, () -> new Object[] {false, true}),
          Map.entry(String.class, () -> new Object[] {"LINE", "", null}),
          Map.entry(Object.class, () -> new Object[] {"other", null}),
          Map.entry(
              Vec2.class, () -> new Object[] {V, Vec2.ZERO, new Vec2(1.7e308, -1.7e308), null}),
          Map.entry(
              Circle.class,
              () ->
                  new Object[] {
                    CIRCLE, new Circle(5, 5, 0), new Circle(-1e308, 1e308, 1e308), null
                  }),
          Map.entry(
              Line.class,
              () ->
                  new Object[] {
                    LINE, new Line(0, 0, 0, 0), new Line(-1e308, 1e308, 1e308, -1e308), null
                  }),
          Map.entry(
              Outline.class,
              () ->
                  new Object[] {BRICK, Outline.polyline(-1e308, 1e308, 1e308, -1e308, 0, 0), null}),
          Map.entry(
              Bounds.class,
              () -> new Object[] {BOX, new Bounds(-1e308, -1e308, 1e308, 1e308), null}),
          Map.entry(
              Obstacle.class,
              () ->
                  new Object[] {
                    LINE, CIRCLE, BOX, new Bounds(0, 0, 1, 1), new Circle(1e308, 0, 0), null
                  }),
          Map.entry(long.class, () -> new Object[] {1_000L, 1L, 0L, -1L, Long.MIN_VALUE}),
          Map.entry(
              Filter.class,
              () -> new Object[] {Filter.DEFAULT, new Filter(2, 3), Filter.ALL, null}),
          Map.entry(
              Traits.class,
              () ->
                  new Object[] {
                    Traits.DEFAULT,
                    Traits.DEFAULT.withMass(2),
                    Traits.DEFAULT.withResponse(Response.SENSOR).withOneWay(true),
                    null
                  }),
          Map.entry(
              SweptCircle.class,
              () ->
                  new Object[] {
                    new SweptCircle(CIRCLE, V),
                    new SweptCircle(0, 0, 0, 0, 0),
                    new SweptCircle(-1e308, 1e308, 1e308, 1e308, 0),
                    new SweptCircle(CIRCLE, V).withAcceleration(0, -1),
                    null
                  }),
          Map.entry(
              SweptSphere.class,
              () ->
                  new Object[] {
                    new SweptSphere(9, 8, 7, 1, -3, -2, -1),
                    new SweptSphere(-1e308, 1e308, 0, 1e308, 1e308, 0, 0),
                    null
                  }),
          Map.entry(
              Kind.class, () -> new Object[] {Kind.CIRCLE, Kind.WALL, Kind.LINE, Kind.PEG, null}),
          Map.entry(Kind[].class, () -> new Object[] {new Kind[] {Kind.LINE}, new Kind[0], null}),
          Map.entry(Outcome.class, () -> withNull(Outcome.values())),
          Map.entry(Feature.class, () -> withNull(Feature.values())),
          Map.entry(Response.class, () -> withNull(Response.values())),
          Map.entry(
              Points.class,
              () ->
                  new Object[] {
                    List.of(V, new Vec2(9, 9), new Vec2(9, 0)),
                    List.of(V),
                    List.of(V, V),
                    Collections.singletonList(null),
                    null
                  }),
          Map.entry(
              List.class,
              () ->
                  new Object[] {
                    List.of(LINE, CIRCLE, BOX, BRICK),
                    List.of(),
                    List.of(BOX, BOX),
                    Collections.singletonList(null),
                    null
                  }),
          Map.entry(
              double[].class,
              () ->
                  new Object[] {
                    new double[] {1, 2, 3, 4},
                    new double[6],
                    new double[0],
                    new double[] {Double.NaN, 1, 2, 3},
                    new double[] {1, 1e308, 2, -1e308, 3, Double.POSITIVE_INFINITY},
                    null
                  }),
          Map.entry(Scene.class, () -> new Object[] {scene(true), scene(false), null}),
          Map.entry(
              Snapshot.class,
              () ->
                  new Object[] {
                    new World(scene(true)).snapshot(), new World(scene(false)).snapshot(), null
                  }),
          Map.entry(World.class, () -> new Object[] {stepped(false), stepped(true), null}),
          Map.entry(Casts.class, () -> new Object[] {casts(), new Casts(), null}),
          Map.entry(Path.class, this::paths),
          Map.entry(
              Reader.class,
              () ->
                  new Object[] {
                    new StringReader("line,0,0,1,1"), new StringReader("no,1"), broken(), null
                  }),
          Map.entry(
              InputStream.class,
              () ->
                  new Object[] {
                    saved(), new ByteArrayInputStream(new byte[99]), brokenStream(), null
                  }),
          Map.entry(
              Appendable.class, () -> new Object[] {new StringWriter(), brokenAppendable(), null}),
          Map.entry(
              OutputStream.class,
              () -> new Object[] {new ByteArrayOutputStream(), brokenOutput(), null}));

  public BadArguments(Path folder) {
    this.folder = folder;
  }

  private static Object[] withNull(Object[] values) {
    return Arrays.copyOf(values, values.length + 1, Object[].class);
  }

  private static Scene scene(boolean collide) {
    SceneBuilder builder = Scene.builder().collide(collide).bounds(0, 0, 100, 100);
    builder.line(40, 0, 40, 30).peg(70, 70, 5).circle(20, 20, 10, 4, 3).circle(60, 20, 10, 4, 3);
    return builder.build();
  }

  private static World stepped(boolean collide) {
    World world = new World(scene(collide));
    world.step(30);
    return world;
  }

  private static Casts casts() {
    Casts casts = new Casts();
    casts.add(5, 5, 1, 2, 3);
    casts.add(5, 5, 0, 0, 0);
    return casts;
  }

  private static Timeline timeline() {
    World world = new World(scene(true));
    Timeline timeline = world.record(100);
    world.step(30);
    return timeline;
  }

  /** For each type the objects on which its methods are called. */
  private static List<Supplier<Object>> receivers(Class<?> type) {
    Map<Class<?>, List<Supplier<Object>>> all =
        Map.ofEntries(
            Map.entry(
                World.class,
                List.of(
                    () -> stepped(true),
                    () -> stepped(false),
                    () -> new World(Scene.builder().collide(false).build()),
                    () -> new World(Scene.builder().outline(BRICK).build()))),
            Map.entry(
                SceneBuilder.class,
                List.of(
                    Scene::builder,
                    () -> Scene.builder().bounds(0, 0, 9, 9),
                    () -> Scene.builder().line(0, 0, 9, 9),
                    () -> Scene.builder().line(0, 0, 1e9, 1e9).circle(5, 5, 1e-9, 2, 3),
                    () -> Scene.builder().collide(true).circle(5, 5, 1, 2, 3))),
            Map.entry(Scene.class, List.of(() -> scene(true), () -> Scene.builder().build())),
            Map.entry(
                Resolver.class,
                List.of(() -> scene(true).resolver(), () -> Resolver.of(List.of()))),
            Map.entry(Casts.class, List.of(BadArguments::casts, Casts::new)),
            Map.entry(Snapshot.class, List.of(() -> stepped(true).snapshot())),
            Map.entry(Timeline.class, List.of(BadArguments::timeline)),
            Map.entry(Uncertainty.class, List.of(() -> stepped(false).uncertainty(1))),
            Map.entry(
                Trajectory.class,
                List.of(
                    () ->
                        scene(true)
                            .resolver()
                            .trace(new SweptCircle(CIRCLE, V), 1, 30, Integer.MAX_VALUE))),
            Map.entry(ImpactLog.class, List.of(() -> stepped(true).impacts())),
            Map.entry(Line.class, List.of(() -> LINE, () -> new Line(0, 1e308, 1e308, 0))),
            Map.entry(Vec2.class, List.of(() -> V)),
            Map.entry(Contact.class, List.of(() -> new Contact(Kind.LINE, 0, 0, 0, 1))),
            Map.entry(Nearest.class, List.of(() -> new Nearest(Kind.LINE, 0, 1, 2, 3))),
            Map.entry(Warning.class, List.of(() -> new Warning(0, Kind.LINE, 0, 1, 2))),
            Map.entry(Filter.class, List.of(() -> Filter.DEFAULT)),
            Map.entry(Traits.class, List.of(() -> Traits.DEFAULT)),
            Map.entry(SweptCircle.class, List.of(() -> new SweptCircle(CIRCLE, V))),
            Map.entry(SweptSphere.class, List.of(() -> new SweptSphere(1, 2, 3, 4, 5, 6, 7))),
            Map.entry(UnfinishedException.class, List.of(BadArguments::unfinished)),
            Map.entry(Circle.class, List.of(() -> CIRCLE)),
            Map.entry(Bounds.class, List.of(() -> BOX)),
            Map.entry(
                Outline.class, List.of(() -> BRICK, () -> Outline.polyline(0, 0, 1e308, 1e308))),
            Map.entry(
                Impact.class,
                List.of(() -> scene(true).resolver().cast(new SweptCircle(CIRCLE, V), 99).get())),
            Map.entry(SceneFormatException.class, List.of(BadArguments::badScene)));
    return all.getOrDefault(type, List.of());
  }

  private static Object unfinished() {
    try {
      Scene endless = Scene.builder().bounds(0, 0, 9, 9).circle(5, 5, 1, 0x1p29, 3).build();
      new World(endless).advanceTo(1);
      throw new IllegalStateException("finished");
    } catch (UnfinishedException e) {
      return e;
    }
  }

  private static Object badScene() {
    try {
      return Scene.read(new StringReader("no,1"), "name");
    } catch (IOException e) {
      return e;
    }
  }

  /** The public methods and constructors of the public types, but those of enums. */
  public static List<Executable> publicOnes() throws IOException {
    try (Stream<Path> files = Files.list(CLASSES)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.matches("[A-Z]\\w*\\.class"))
          .sorted()
          .map(name -> load("dev.carom." + name.replace(".class", "")))
          .filter(type -> Modifier.isPublic(type.getModifiers()) && !type.isEnum())
          .flatMap(
              type ->
                  Stream.<Executable>concat(
                      Stream.of(type.getConstructors()), Stream.of(type.getDeclaredMethods())))
          .filter(one -> Modifier.isPublic(one.getModifiers()) && !one.isSynthetic())
          .toList();
    }
  }

  private static Class<?> load(String name) {
    try {
      return Class.forName(name);
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException(e);
    }
  }

  public List<Call> calls(Executable called) {
    return calls(called, objects(called));
  }

  private static List<Supplier<Object>> objects(Executable called) {
    boolean needsNone =
        called instanceof Constructor<?> || Modifier.isStatic(called.getModifiers());
    return needsNone ? List.of(() -> null) : receivers(called.getDeclaringClass());
  }

  /** A call with good arguments for each object, but for a null as one of them; -1 for none. */
  public List<Call> callsWithNull(Executable called, int parameter) {
    Object[] arguments = good(types(called));
    if (parameter >= 0) {
      arguments[parameter] = null;
    }
    return objects(called).stream().map(object -> call(called, object.get(), arguments)).toList();
  }

  /** The types of the parameters; a list of points is another one than a list of obstacles. */
  private static Class<?>[] types(Executable called) {
    return Arrays.stream(called.getGenericParameterTypes())
        .map(
            type ->
                type.getTypeName().endsWith("<" + Vec2.class.getName() + ">") ? Points.class : type)
        .map(type -> type instanceof ParameterizedType of ? of.getRawType() : type)
        .toArray(Class<?>[]::new);
  }

  /** Stands for a list of points. */
  private interface Points {}

  /** Each argument in turn takes each of its values, the others good ones; then some at random. */
  public List<Call> calls(Executable called, List<Supplier<Object>> receivers) {
    if (receivers.isEmpty()) {
      throw new IllegalArgumentException(called + ": expected an object to call it on");
    }
    List<Call> calls = new ArrayList<>();
    Class<?>[] types = types(called);
    Random random = new Random(1);
    for (Supplier<Object> receiver : receivers) {
      calls.add(call(called, receiver.get(), good(types)));
      for (int k = 0; k < types.length; k++) {
        for (int value = 1; value < values(types[k]).length; value++) {
          Object[] arguments = good(types);
          arguments[k] = values(types[k])[value];
          calls.add(call(called, receiver.get(), arguments));
        }
      }
      for (int n = 0; n < RANDOM_CALLS && types.length > 1; n++) {
        Object[] arguments =
            Stream.of(types)
                .map(this::values)
                .map(values -> values[random.nextInt(values.length)])
                .toArray();
        calls.add(call(called, receiver.get(), arguments));
      }
    }
    return calls;
  }

  private Object[] good(Class<?>[] types) {
    return Stream.of(types).map(type -> values(type)[0]).toArray();
  }

  private Object[] values(Class<?> type) {
    Supplier<Object[]> values = this.values.get(type);
    if (values == null) {
      throw new IllegalArgumentException(type + ": expected values for parameters of this type");
    }
    return values.get();
  }

  private static Call call(Executable called, Object receiver, Object[] arguments) {
    try {
      Object answer =
          called instanceof Constructor<?> constructor
              ? constructor.newInstance(arguments)
              : ((Method) called).invoke(receiver, arguments);
      return new Call(Arrays.asList(arguments), answer, null);
    } catch (InvocationTargetException e) {
      return new Call(Arrays.asList(arguments), null, e.getCause());
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(called.toString(), e);
    }
  }

  private Object[] paths() {
    try {
      Path bad = Files.writeString(folder.resolve("scene.csv"), "no,1");
      return new Object[] {folder.resolve("no/file"), bad, folder, null};
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static InputStream saved() {
    return new ByteArrayInputStream(SnapshotBytes.of(stepped(true).snapshot()));
  }

  private static Reader broken() {
    return new InputStreamReader(brokenStream(), StandardCharsets.UTF_8);
  }

  private static InputStream brokenStream() {
    return new InputStream() {
      @Override
      public int read() throws IOException {
        throw new IOException("broken");
      }

      @Override
      public int read(byte[] to, int from, int length) throws IOException {
        throw new IOException("broken");
      }
    };
  }

  private static OutputStream brokenOutput() {
    return new OutputStream() {
      @Override
      public void write(int one) throws IOException {
        throw new IOException("broken");
      }
    };
  }

  private static Appendable brokenAppendable() {
    return new OutputStreamWriter(brokenOutput(), StandardCharsets.UTF_8) {
      @Override
      public Writer append(CharSequence text) throws IOException {
        throw new IOException("broken");
      }
    };
  }
}
