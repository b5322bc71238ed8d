// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.exact.BoundedNumber;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.sweep.SideSweep;
import dev.carom.internal.sweep.TimeOfImpact;
import dev.carom.internal.sweep.WallSweep;
import dev.carom.oracle.MovingLineQuery;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.Query;
import dev.carom.oracle.SegmentQuery;
import dev.carom.oracle.WallQuery;
import java.lang.reflect.Field;
import java.util.Arrays;

/**
 * The constants on which the detector's certainty rests: bounds of rounding errors, and limits of
 * the range in which those hold.
 *
 * <p>Two are not here. {@code MOST}, an upper limit of two sweeps: what overflows is infinite or
 * not a number, and leaves the answer open by itself. And the condition of {@link TimeOfImpact}
 * that the errors of a step be a quarter of it, at most, in all: where they are not, they are more
 * than an ulp of the time already.
 */
enum RoundingBound {
  ROOT_DOT(TimeOfImpact.class, "DOT_BOUND"),
  ROOT_GAP(TimeOfImpact.class, "GAP_BOUND"),
  ROOT_REACH(TimeOfImpact.class, "DISCRIMINANT_BOUND"),
  /** The rounding of a place in the error of a step, and so the whole of f's share. */
  ROOT_PLACE(TimeOfImpact.class, "PLACE_BOUND"),
  ROOT_TINY(TimeOfImpact.class, "TINY"),
  /** The rounding of h in the error of a step. */
  SIDE_PLACE(SideSweep.class, Kind.BOUND, 256 * 0x1p-106),
  /** The rounding of the divisions in the error of a step. */
  SIDE_LEAN(SideSweep.class, Kind.BOUND, 16 * 0x1p-53),
  SIDE_LEAST(SideSweep.class, "LEAST_SAFE"),
  SIDE_LEAST_LENGTH(SideSweep.class, "LEAST_LENGTH"),
  /** The bounds of the gap's tail and of the remainder: each is generous enough for both. */
  WALL_REST(WallSweep.class, Kind.BOUND, 0x1p-104, 0x1p-50),
  WALL_LEAST(WallSweep.class, "LEAST_SAFE"),
  PREDICATES_CROSS(Predicates.class, "CROSS_BOUND"),
  PREDICATES_GAP(Predicates.class, "GAP_BOUND"),
  PREDICATES_DISCRIMINANT(Predicates.class, "DISCRIMINANT_BOUND"),
  PREDICATES_CORNER(Predicates.class, "CORNER_BOUND"),
  PREDICATES_TINY(Predicates.class, "TINY"),
  BOUNDED(BoundedNumber.class, "BOUND"),
  BOUNDED_LEAST(BoundedNumber.class, "LEAST_TERM");

  /** The purpose of a constant. */
  enum Kind {
    /** Bounds an error: none at 0. */
    BOUND,
    /** Keeps small numbers out: none at 0. */
    LEAST
  }

  private final Class<?> owner;
  private final Kind kind;

  @SuppressWarnings("ImmutableEnumChecker") // never handed out
  private final double[] values;

  RoundingBound(Class<?> owner, String field) {
    this(owner, kind(field), read(owner, field));
  }

  RoundingBound(Class<?> owner, Kind kind, double... values) {
    this.owner = owner;
    this.kind = kind;
    this.values = values;
  }

  private static Kind kind(String field) {
    return field.endsWith("BOUND") ? Kind.BOUND : Kind.LEAST;
  }

  private static double read(Class<?> owner, String field) {
    try {
      Field constant = owner.getDeclaredField(field);
      constant.setAccessible(true);
      return constant.getDouble(null);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  boolean isBound() {
    return kind == Kind.BOUND;
  }

  /** The first value; a bound as a multiple of u = 2^-53 or of u^2. */
  String inUnits() {
    double value = values[0];
    if (!isBound()) {
      return "2^" + Math.getExponent(value);
    }
    return value > 0x1p-60 ? value * 0x1p53 + " u" : value * 0x1p106 + " u^2";
  }

  /** Whether a query can come to this constant at all. */
  boolean concerns(Query query) {
    if (owner == Predicates.class || owner == BoundedNumber.class) {
      return !(query instanceof WallQuery);
    }
    return (query instanceof SegmentQuery || query instanceof MovingLineQuery)
        ? owner != WallSweep.class
        : query instanceof PairQuery ? owner == TimeOfImpact.class : owner == WallSweep.class;
  }

  /** Weakens this bound in a class file of its class: by a factor, 0 to remove it. */
  void scale(String className, ConstantPool pool, double factor) {
    if (owner.getName().equals(className)) {
      for (double value : values) {
        pool.replace(value, value * factor);
      }
    }
  }

  /** Whether a static constant of a class is this one. */
  boolean is(Field constant) {
    return constant.getDeclaringClass() == owner
        && Arrays.stream(values).anyMatch(value -> value == read(owner, constant.getName()));
  }
}
