// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import com.sun.source.tree.BinaryTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.SynchronizedTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.Tree.Kind;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePath;
import com.sun.source.util.TreePathScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import javax.lang.model.element.Element;
import javax.lang.model.element.ElementKind;
import javax.lang.model.element.Modifier;
import javax.lang.model.element.TypeElement;
import javax.lang.model.type.DeclaredType;
import javax.lang.model.type.TypeKind;
import javax.lang.model.type.TypeMirror;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.ToolProvider;

/**
 * Where sources rely on the identity of a public record of the library: compare it by {@code ==},
 * synchronize on it, or give it to what does. Once such records are value classes they have none.
 */
final class IdentityUses extends TreePathScanner<Void, Void> {

  private static final Set<String> CALLS =
      Set.of("identityHashCode", "isSameAs", "isNotSameAs", "assertSame", "assertNotSame");

  private static final Set<String> MONITORS = Set.of("wait", "notify", "notifyAll");

  private static final Set<String> HOLDERS =
      Set.of(
          "java.util.IdentityHashMap",
          "java.util.WeakHashMap",
          "java.lang.ref.WeakReference",
          "java.lang.ref.SoftReference",
          "java.lang.ref.PhantomReference");

  private final Trees trees;
  private final List<String> found = new ArrayList<>();

  private IdentityUses(Trees trees) {
    this.trees = trees;
  }

  /** The places in sources that compile on this class path: {@code File.java:12: a == b}. */
  static List<String> in(Iterable<? extends JavaFileObject> sources) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    DiagnosticCollector<JavaFileObject> complaints = new DiagnosticCollector<>();
    List<String> options =
        List.of("-proc:none", "-implicit:none", "-cp", System.getProperty("java.class.path"));
    JavacTask task = (JavacTask) compiler.getTask(null, null, complaints, options, null, sources);
    IdentityUses uses = new IdentityUses(Trees.instance(task));
    Iterable<? extends CompilationUnitTree> units = task.parse();
    task.analyze();
    complaints.getDiagnostics().forEach(IdentityUses::demandNoError);
    units.forEach(unit -> uses.scan(unit, null));
    return uses.found;
  }

  /** Where a type is not known, no use of it would be seen. */
  private static void demandNoError(Diagnostic<?> complaint) {
    if (complaint.getKind() == Diagnostic.Kind.ERROR) {
      throw new AssertionError(complaint);
    }
  }

  @Override
  public Void visitBinary(BinaryTree tree, Void unused) {
    boolean compares = tree.getKind() == Kind.EQUAL_TO || tree.getKind() == Kind.NOT_EQUAL_TO;
    ExpressionTree left = tree.getLeftOperand();
    ExpressionTree right = tree.getRightOperand();
    boolean withNull = left.getKind() == Kind.NULL_LITERAL || right.getKind() == Kind.NULL_LITERAL;
    if (compares && !withNull && (isRecord(left) || isRecord(right))) {
      add(tree);
    }
    return super.visitBinary(tree, null);
  }

  @Override
  public Void visitSynchronized(SynchronizedTree tree, Void unused) {
    if (isRecord(tree.getExpression())) {
      add(tree.getExpression());
    }
    return super.visitSynchronized(tree, null);
  }

  @Override
  public Void visitMethodInvocation(MethodInvocationTree tree, Void unused) {
    Element method = trees.getElement(getCurrentPath());
    String name = method.getSimpleName().toString();
    boolean hands = CALLS.contains(name) && tree.getArguments().stream().anyMatch(this::isRecord);
    boolean locks =
        MONITORS.contains(name)
            && tree.getMethodSelect() instanceof MemberSelectTree select
            && isRecord(trees.getTypeMirror(new TreePath(selected(tree), select.getExpression())));
    if (hands || locks) {
      add(tree);
    }
    return super.visitMethodInvocation(tree, null);
  }

  @Override
  public Void visitNewClass(NewClassTree tree, Void unused) {
    TypeMirror type = trees.getTypeMirror(getCurrentPath());
    if (type instanceof DeclaredType made
        && HOLDERS.contains(((TypeElement) made.asElement()).getQualifiedName().toString())
        && !made.getTypeArguments().isEmpty()
        && isRecord(made.getTypeArguments().get(0))) {
      add(tree);
    }
    return super.visitNewClass(tree, null);
  }

  private TreePath selected(MethodInvocationTree call) {
    return new TreePath(getCurrentPath(), call.getMethodSelect());
  }

  private boolean isRecord(Tree tree) {
    return isRecord(type(tree));
  }

  private TypeMirror type(Tree tree) {
    return trees.getTypeMirror(new TreePath(getCurrentPath(), tree));
  }

  /** One of the library's: a public record, or an interface that only such records implement. */
  private static boolean isRecord(TypeMirror type) {
    if (type == null || type.getKind() != TypeKind.DECLARED) {
      return false;
    }
    TypeElement element = (TypeElement) ((DeclaredType) type).asElement();
    return element.getQualifiedName().toString().matches("dev\\.carom\\.[A-Z]\\w*")
        && element.getModifiers().contains(Modifier.PUBLIC)
        && (element.getKind() == ElementKind.RECORD
            || (!element.getPermittedSubclasses().isEmpty()
                && element.getPermittedSubclasses().stream().allMatch(IdentityUses::isRecord)));
  }

  private void add(Tree tree) {
    CompilationUnitTree unit = getCurrentPath().getCompilationUnit();
    String path = unit.getSourceFile().getName();
    long start = trees.getSourcePositions().getStartPosition(unit, tree);
    found.add(
        path.substring(path.lastIndexOf('/') + 1)
            + ":"
            + unit.getLineMap().getLineNumber(start)
            + ": "
            + tree.toString().replaceAll("\\s+", " "));
  }
}
