// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Nothing relies on the identity of a public record: in a later Java they can be value classes. */
class IdentityTest {

  private static final String EXAMPLE =
      """
      import dev.carom.*;
      import java.util.*;
      import java.lang.ref.WeakReference;
      class Example {
        boolean same(Vec2 a, Vec2 b, Object o, Obstacle p) throws Exception {
          synchronized (a) { a.notify(); }
          new IdentityHashMap<Line, String>();
          new WeakReference<Obstacle>(p);
          System.identityHashCode(b);
          org.assertj.core.api.Assertions.assertThat(a).isSameAs(b);
          return a != b || o == p;
        }
        boolean allowed(Vec2 a, World one, World other, Kinds kinds) {
          synchronized (one) { one.notifyAll(); }
          new IdentityHashMap<World, Vec2>();
          return a == null || one == other || a.x() == 1 || a.equals(null)
              || kinds.kind == Kind.PEG;
        }
        record Kinds(Kind kind) {}
      }
      """;

  @Test
  void seesEachUseOfIdentity() throws IOException {
    assertThat(IdentityUses.in(List.of(source(EXAMPLE))))
        .containsExactly(
            "Example.java:6: (a)",
            "Example.java:6: a.notify()",
            "Example.java:7: new IdentityHashMap<Line, String>()",
            "Example.java:8: new WeakReference<Obstacle>(p)",
            "Example.java:9: System.identityHashCode(b)",
            "Example.java:10: org.assertj.core.api.Assertions.assertThat(a).isSameAs(b)",
            "Example.java:11: a != b",
            "Example.java:11: o == p");
  }

  /** The library itself. */
  @Test
  @Tag("long")
  void nothingReliesOnTheIdentityOfRecords() throws IOException {
    List<Path> files = new ArrayList<>();
    for (String root : List.of("../src/main")) {
      files.addAll(sources(Path.of(root, "java")));
    }
    try (var manager =
        ToolProvider.getSystemJavaCompiler().getStandardFileManager(null, null, null)) {
      assertThat(files).hasSizeGreaterThan(150);
      assertThat(IdentityUses.in(manager.getJavaFileObjectsFromPaths(files))).isEmpty();
    }
  }

  /** Without the tests that need ArchUnit, which the harness has not. */
  private static List<Path> sources(Path root) throws IOException {
    try (Stream<Path> files = Files.walk(root)) {
      return files
          .filter(file -> file.toString().endsWith(".java"))
          .filter(file -> !file.endsWith("module-info.java"))
          .filter(file -> !read(file).contains("com.tngtech.archunit"))
          .toList();
    }
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static JavaFileObject source(String text) {
    return new SimpleJavaFileObject(
        URI.create("string:///Example.java"), JavaFileObject.Kind.SOURCE) {
      @Override
      public CharSequence getCharContent(boolean ignoreEncodingErrors) {
        return text;
      }
    };
  }
}
