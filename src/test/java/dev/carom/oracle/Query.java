// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.List;
import java.util.StringJoiner;
import java.util.stream.DoubleStream;

/** A question about contact: doubles, taken as exact real numbers. */
public sealed interface Query extends Question
    permits SegmentQuery, MovingLineQuery, PairQuery, WallQuery {

  @Override
  Contact truth();

  /** The answer of a detector under test. */
  Answer ask(Detector detector);

  /** The names of the numbers, in the order of the record. */
  List<String> names();

  /** The numbers in the same order. */
  double[] numbers();

  /** A query of the same kind with other numbers. */
  Query with(double... numbers);

  @Override
  default boolean isFair() {
    double[] numbers = numbers();
    return DoubleStream.of(numbers).limit(numbers.length - 1L).allMatch(Double::isFinite);
  }

  @Override
  default String hex() {
    StringJoiner text = new StringJoiner(", ", getClass().getSimpleName() + "(", ")");
    List<String> names = names();
    double[] numbers = numbers();
    for (int i = 0; i < numbers.length; i++) {
      text.add("/*" + names.get(i) + "*/ " + Double.toHexString(numbers[i]));
    }
    return text.toString();
  }
}
