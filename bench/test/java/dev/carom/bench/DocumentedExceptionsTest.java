// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.BadArguments;
import dev.carom.BadArguments.Call;
import java.io.IOException;
import java.lang.reflect.Executable;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Calls each public method and constructor of the library with good and bad arguments. Whatever it
 * throws must be named by a {@code @throws} in its Javadoc, except for a null: the package page
 * says for all methods what a null throws.
 */
class DocumentedExceptionsTest {

  /** They need more things than fit into memory, or more calls than one. */
  private static final Set<String> BEYOND_THIS_TEST =
      Set.of(
          "World.addCircle(double, double, double, double, double, Traits): IllegalStateException",
          "World.addLine(double, double, double, double, Traits): IllegalStateException",
          "World.addOutline(Outline, Traits): IllegalStateException",
          "World.addPeg(double, double, double, Traits): IllegalStateException",
          "World.advanceToImpact(double): UnfinishedException");

  /** The calls of each method that threw something. */
  private static final Map<Executable, List<Call>> FAILED = new HashMap<>();

  @BeforeAll
  static void callAll(@TempDir Path folder) throws IOException {
    BadArguments arguments = new BadArguments(folder);
    for (Executable called : BadArguments.publicOnes()) {
      FAILED.put(called, failed(arguments.calls(called)));
    }
  }

  private static List<Call> failed(List<Call> calls) {
    return calls.stream().filter(call -> call.thrown() != null).toList();
  }

  @Test
  void whatIsThrownIsDocumented() throws IOException {
    Map<String, String> undocumented = new TreeMap<>();
    for (Executable called : FAILED.keySet()) {
      Set<String> documented = ThrowsTags.of(called);
      for (Call call : FAILED.get(called)) {
        if (!isDocumented(call, documented)) {
          undocumented.put(
              ThrowsTags.signature(called) + ": " + call.thrown(), call.arguments().toString());
        }
      }
    }
    assertThat(undocumented).isEmpty();
  }

  /** A tag that no call proves is stale, or the arguments here are too tame. */
  @Test
  void whatIsDocumentedIsThrown() throws IOException {
    Set<String> unproved = new TreeSet<>();
    for (Executable called : FAILED.keySet()) {
      List<String> documented = new ArrayList<>(ThrowsTags.of(called));
      FAILED.get(called).forEach(call -> names(call.thrown()).forEach(documented::remove));
      documented.forEach(name -> unproved.add(ThrowsTags.signature(called) + ": " + name));
    }
    assertThat(unproved).isEqualTo(BEYOND_THIS_TEST);
  }

  @Test
  void anUndocumentedExceptionIsSeen(@TempDir Path folder) throws Exception {
    Executable charAt = String.class.getMethod("charAt", int.class);
    List<Call> failed = failed(new BadArguments(folder).calls(charAt, List.of(() -> "text")));

    assertThat(failed).hasSizeGreaterThan(3);
    assertThat(failed)
        .noneMatch(call -> isDocumented(call, Set.of("IndexOutOfBoundsException")))
        .allMatch(call -> isDocumented(call, Set.of("StringIndexOutOfBoundsException")));
  }

  /**
   * Whether a method documents what a call threw. Unchecked exceptions count by their own names
   * only: an ArrayIndexOutOfBoundsException is a mistake, whatever is documented.
   */
  private static boolean isDocumented(Call call, Set<String> documented) {
    Throwable thrown = call.thrown();
    if (thrown instanceof NullPointerException) {
      return call.hasNull() && thrown.getMessage().endsWith(" is null");
    }
    return thrown instanceof IOException
        ? names(thrown).stream().anyMatch(documented::contains)
        : documented.contains(thrown.getClass().getSimpleName());
  }

  /** The simple names of an exception's class and of those that it extends. */
  private static Set<String> names(Throwable thrown) {
    return Stream.<Class<?>>iterate(
            thrown.getClass(), type -> type != Object.class, Class::getSuperclass)
        .map(Class::getSimpleName)
        .collect(Collectors.toSet());
  }
}
