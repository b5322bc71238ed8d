// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.io.IOException;
import java.lang.reflect.Executable;
import java.lang.reflect.Method;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * No public method or constructor takes or returns null. All of them are found by reflection, so a
 * new one is asked, too. The message names the parameter.
 */
class NoNullTest {

  @TempDir private Path folder;

  private static Stream<Executable> all() throws IOException {
    return BadArguments.publicOnes().stream().filter(call -> !call.getName().equals("equals"));
  }

  static Stream<Arguments> references() throws IOException {
    return all()
        .flatMap(
            call ->
                IntStream.range(0, call.getParameterCount())
                    .filter(i -> !call.getParameterTypes()[i].isPrimitive())
                    .mapToObj(i -> Arguments.of(call, i)));
  }

  static Stream<Executable> answers() throws IOException {
    return all().filter(call -> call instanceof Method m && !m.getReturnType().isPrimitive());
  }

  @ParameterizedTest
  @MethodSource("references")
  void nullIsRefused(Executable call, int parameter) {
    assertThat(new BadArguments(folder).callsWithNull(call, parameter).get(0).thrown())
        .isInstanceOf(NullPointerException.class)
        .hasMessage(call.getParameters()[parameter].getName() + " is null");
  }

  @Test
  void anElementIsRefusedByItsPlace() {
    assertThatNullPointerException()
        .isThrownBy(() -> Resolver.of(Collections.<Obstacle>singletonList(null)))
        .withMessage("obstacles[0] is null");
    assertThatNullPointerException()
        .isThrownBy(() -> Resolver.of(List.of()).nearest(1, 2, Kind.LINE, null))
        .withMessage("kinds[1] is null");
  }

  @ParameterizedTest
  @MethodSource("answers")
  void nullIsNoAnswer(Executable call) {
    assertThat(new BadArguments(folder).callsWithNull(call, -1))
        .filteredOn(made -> made.thrown() == null)
        .allSatisfy(made -> assertThat(made.answer()).isNotNull());
  }
}
