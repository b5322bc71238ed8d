// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.lang.reflect.RecordComponent;
import java.util.StringJoiner;
import java.util.stream.DoubleStream;

/** A question about contact: doubles, taken as exact real numbers. */
public sealed interface Query extends Question
    permits SegmentQuery, MovingLineQuery, PairQuery, WallQuery {

  @Override
  Contact truth();

  /** The answer of a detector under test. */
  Answer ask(Detector detector);

  /** The numbers in the order of the record. */
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
    RecordComponent[] names = getClass().getRecordComponents();
    double[] numbers = numbers();
    for (int i = 0; i < numbers.length; i++) {
      text.add("/*" + names[i].getName() + "*/ " + Double.toHexString(numbers[i]));
    }
    return text.toString();
  }
}
