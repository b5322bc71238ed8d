// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import com.sun.source.doctree.DocCommentTree;
import com.sun.source.doctree.ThrowsTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.DocTrees;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePath;
import com.sun.source.util.TreePathScanner;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** The {@code @throws} tags in the source of the public package. */
final class ThrowsTags {

  private static final Path SOURCES = Path.of("../src/main/java/dev/carom");
  private static final Map<Class<?>, Map<String, Set<String>>> BY_TYPE = new HashMap<>();

  private ThrowsTags() {}

  /**
   * The simple names of the exceptions that the Javadoc of a method or a constructor names. A
   * method of an interface is documented there.
   */
  static Set<String> of(Executable called) throws IOException {
    Class<?> type = called.getDeclaringClass();
    Optional<Method> above = above(called);
    if (above.isPresent()) {
      return of(above.get());
    }
    if (!BY_TYPE.containsKey(type)) {
      BY_TYPE.put(type, parse(type));
    }
    return BY_TYPE.get(type).getOrDefault(signature(called), Set.of());
  }

  private static Optional<Method> above(Executable called) {
    Class<?> type = called.getDeclaringClass();
    return Stream.of(type.getInterfaces())
        .filter(above -> above.getPackage() == type.getPackage())
        .flatMap(above -> Stream.of(above.getMethods()))
        .filter(method -> called instanceof Method && method.getName().equals(called.getName()))
        .filter(method -> Arrays.equals(method.getParameterTypes(), called.getParameterTypes()))
        .findAny();
  }

  /** The type, the name and the types of the parameters, all by simple names. */
  static String signature(Executable called) {
    String type = called.getDeclaringClass().getSimpleName();
    String name = called instanceof Constructor<?> ? type : called.getName();
    return Stream.of(called.getParameterTypes())
        .map(Class::getSimpleName)
        .collect(Collectors.joining(", ", type + "." + name + "(", ")"));
  }

  private static Map<String, Set<String>> parse(Class<?> type) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
      JavacTask task =
          (JavacTask)
              compiler.getTask(
                  null,
                  files,
                  null,
                  null,
                  null,
                  files.getJavaFileObjects(SOURCES.resolve(type.getSimpleName() + ".java")));
      Scanner scanner = new Scanner(type, DocTrees.instance(task));
      for (CompilationUnitTree unit : task.parse()) {
        scanner.scan(unit, null);
      }
      return scanner.tags;
    }
  }

  private static final class Scanner extends TreePathScanner<Void, Void> {

    final Map<String, Set<String>> tags = new HashMap<>();
    private final Class<?> type;
    private final DocTrees docs;

    Scanner(Class<?> type, DocTrees docs) {
      this.type = type;
      this.docs = docs;
    }

    @Override
    public Void visitMethod(MethodTree method, Void unused) {
      TreePath path = getCurrentPath();
      ClassTree in = (ClassTree) path.getParentPath().getLeaf();
      if (in.getSimpleName().contentEquals(type.getSimpleName())) {
        tags.put(signature(method), tags(docs.getDocCommentTree(path)));
      }
      return null;
    }

    private String signature(MethodTree method) {
      String name = method.getName().toString().replace("<init>", type.getSimpleName());
      String parameters = isCompact(method) ? components() : parameters(method);
      return type.getSimpleName() + "." + name + "(" + parameters + ")";
    }

    /** The parser gives a compact constructor no parameters. */
    private boolean isCompact(MethodTree method) {
      return type.isRecord()
          && method.getName().contentEquals("<init>")
          && method.getParameters().isEmpty();
    }

    private String components() {
      return Stream.of(type.getRecordComponents())
          .map(RecordComponent::getType)
          .map(Class::getSimpleName)
          .collect(Collectors.joining(", "));
    }

    private static String parameters(MethodTree method) {
      return method.getParameters().stream()
          .map(parameter -> simpleName(parameter.getType()))
          .collect(Collectors.joining(", "));
    }

    private static String simpleName(Tree type) {
      return type.toString().replaceAll("<.*>", "").replace("...", "[]");
    }

    private static Set<String> tags(DocCommentTree comment) {
      Set<String> names = new TreeSet<>();
      if (comment != null) {
        comment.getBlockTags().stream()
            .filter(ThrowsTree.class::isInstance)
            .forEach(tag -> names.add(((ThrowsTree) tag).getExceptionName().toString()));
      }
      return names;
    }
  }
}
