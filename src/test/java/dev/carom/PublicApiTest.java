// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Parameter;
import java.lang.reflect.Type;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * The public API is what {@code public-api.txt} lists, one element a line: so no change of it goes
 * unseen. A line that disappears, or changes, breaks callers compiled against the last release; a
 * new one does not. {@code -Dcarom.api=write} writes the list anew.
 */
class PublicApiTest {

  private static final Path LIST = Path.of("test/resources/public-api.txt");

  @Test
  void isAsListed() throws Exception {
    List<String> api = api(classes(World.class));
    if ("write".equals(System.getProperty("carom.api"))) {
      Files.write(LIST, api);
    }
    List<String> listed = Files.readAllLines(LIST);
    assertThat(api)
        .as("gone or changed: breaks callers; if meant, say so in the changelog and write %s", LIST)
        .containsAll(listed);
    assertThat(listed).as("new: write %s and review it", LIST).containsAll(api);
  }

  @Test
  void hasAtMostThirtyTypes() throws Exception {
    assertThat(api(classes(World.class)).stream().filter(line -> !line.startsWith("  ")))
        .hasSizeBetween(1, 30);
  }

  @Test
  void seesWhatCallersSeeAndNothingElse() {
    assertThat(api(List.of(Sample.class)))
        .containsExactly(
            "dev.carom.PublicApiTest.Sample: class, extends java.lang.Object",
            "  dev.carom.PublicApiTest.Sample.MOST: public static final int",
            "  dev.carom.PublicApiTest.Sample.Sample(int)",
            "  dev.carom.PublicApiTest.Sample.list(double...): protected static"
                + " java.util.List<java.lang.String> throws java.io.IOException");
  }

  /** One of each kind of member. */
  @SuppressWarnings("unused")
  static class Sample {
    public static final int MOST = 1;
    int hidden;

    public Sample(int n) {
      hidden = n;
    }

    protected static List<String> list(double... of) throws IOException {
      return List.of();
    }

    void ours() {}
  }

  static List<Class<?>> classes(Class<?> one) throws Exception {
    List<Class<?>> found = new ArrayList<>();
    for (String name : names(one)) {
      Class<?> type = Class.forName(name, false, one.getClassLoader());
      if (Modifier.isPublic(type.getModifiers())) {
        found.add(type);
      }
    }
    return found;
  }

  private static List<String> names(Class<?> one) throws URISyntaxException, IOException {
    Path root = Path.of(one.getProtectionDomain().getCodeSource().getLocation().toURI());
    String folder = one.getPackageName().replace('.', '/');
    try (Stream<Path> files = Files.list(root.resolve(folder))) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(".class") && !name.startsWith("package-"))
          .map(name -> one.getPackageName() + "." + name.replace(".class", ""))
          .sorted()
          .toList();
    }
  }

  private static List<String> api(List<Class<?>> types) {
    List<String> lines = new ArrayList<>();
    for (Class<?> type : types) {
      lines.add(type.getCanonicalName() + ": " + kind(type));
      Stream.of(type.getDeclaredConstructors(), type.getDeclaredFields(), type.getDeclaredMethods())
          .flatMap(Arrays::stream)
          .filter(PublicApiTest::isSeen)
          .map(member -> "  " + type.getCanonicalName() + "." + describe(member))
          .sorted()
          .forEach(lines::add);
    }
    return lines;
  }

  private static boolean isSeen(Member member) {
    int seen = Modifier.PUBLIC | Modifier.PROTECTED;
    return (member.getModifiers() & seen) != 0 && !member.isSynthetic();
  }

  private static String kind(Class<?> type) {
    String kind = type.isRecord() ? "record" : type.isEnum() ? "enum" : "class";
    int modifiers = type.getModifiers() & (Modifier.FINAL | Modifier.ABSTRACT);
    String words =
        type.isInterface()
            ? (type.isSealed() ? "sealed " : "") + "interface"
            : (Modifier.toString(modifiers) + " " + kind).strip()
                + ", extends "
                + type.getGenericSuperclass().getTypeName();
    return Stream.of(type.getGenericInterfaces())
        .map(Type::getTypeName)
        .collect(Collectors.joining(", ", words + (hasInterfaces(type) ? ", is a " : ""), ""));
  }

  private static boolean hasInterfaces(Class<?> type) {
    return type.getInterfaces().length > 0;
  }

  private static String describe(Member member) {
    String modifiers = Modifier.toString(member.getModifiers() & ~Modifier.TRANSIENT);
    if (member instanceof Field field) {
      return field.getName() + ": " + modifiers + " " + field.getGenericType().getTypeName();
    }
    if (member instanceof Constructor<?> constructor) {
      return constructor.getDeclaringClass().getSimpleName() + call(constructor);
    }
    Method method = (Method) member;
    String result = modifiers + " " + method.getGenericReturnType().getTypeName();
    return method.getName() + parameters(method) + ": " + result + thrown(method);
  }

  private static String call(Executable executable) {
    return parameters(executable) + thrown(executable);
  }

  private static String parameters(Executable executable) {
    return Stream.of(executable.getParameters())
        .map(PublicApiTest::type)
        .collect(Collectors.joining(", ", "(", ")"));
  }

  private static String type(Parameter parameter) {
    String name = parameter.getParameterizedType().getTypeName();
    return parameter.isVarArgs() ? name.replaceFirst("\\[\\]$", "...") : name;
  }

  private static String thrown(Executable executable) {
    return Stream.of(executable.getGenericExceptionTypes())
        .map(type -> " throws " + type.getTypeName())
        .collect(Collectors.joining());
  }
}
