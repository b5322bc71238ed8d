// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.Falls;
import dev.carom.internal.sweep.SegmentSweep;
import dev.carom.internal.sweep.SphereSweep;
import dev.carom.internal.sweep.WallSweep;
import dev.carom.oracle.MovingLineQuery;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.Part;
import dev.carom.oracle.Query;
import dev.carom.oracle.SegmentQuery;
import dev.carom.oracle.SphereQuery;
import dev.carom.oracle.WallQuery;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;

/**
 * A copy of the detector, made of {@link PatchedClasses}: some of its rounding bounds are scaled.
 */
final class PatchedDetector {
  private final MethodHandle lineContact;
  private final MethodHandle lineTime;
  private final MethodHandle pairContact;
  private final MethodHandle pairTime;
  private final MethodHandle wallTime;
  private final MethodHandle sphereTime;

  /**
   * The part that is hit, and the time.
   *
   * @param part null if exact numbers were asked for the time of a miss, and gave no answer
   * @param time infinite for a miss
   */
  record Reply(Part part, double time) {}

  private PatchedDetector(Map<RoundingBound, Double> factors) {
    ClassLoader classes =
        new PatchedClasses(
            (name, pool) -> factors.forEach((bound, factor) -> bound.scale(name, pool, factor)));
    lineContact = handle(classes, SegmentSweep.class, "contact", 11, 12);
    lineTime = handle(classes, SegmentSweep.class, "time", 12, 12);
    pairContact = handle(classes, DiskSweep.class, "contact", 10, 11);
    pairTime = handle(classes, DiskSweep.class, "time", 11, 11);
    wallTime = handle(classes, WallSweep.class, "time", 5, 5);
    sphereTime = handle(classes, SphereSweep.class, "time", 15, 15);
  }

  /** The detector with one bound scaled down: 1 for none, 0 to remove it. */
  static PatchedDetector scaled(RoundingBound bound, double factor) {
    return new PatchedDetector(Map.of(bound, factor));
  }

  /** The last rung alone: with infinite bounds nothing but exact numbers decides. */
  static PatchedDetector exact() {
    Map<RoundingBound, Double> factors = new EnumMap<>(RoundingBound.class);
    for (RoundingBound bound : RoundingBound.values()) {
      if (bound.isBound()) {
        factors.put(bound, Double.POSITIVE_INFINITY);
      }
    }
    return new PatchedDetector(factors);
  }

  /** The numbers of a query in the order of the detector's arguments. */
  private static double[] arguments(Query query) {
    double[] n = query.numbers();
    if (query instanceof SegmentQuery) {
      return new double[] {n[4], n[5], n[6], n[7], n[8], n[0], n[1], n[2], n[3], 0, 0, n[9]};
    }
    return query instanceof MovingLineQuery
        ? new double[] {n[4], n[5], n[6], n[7], n[8], n[0], n[1], n[2], n[3], n[9], n[10], n[11]}
        : n;
  }

  /** Two disks as spheres whose centres stay in one plane. */
  private static double[] inSpace(double... n) {
    return new double[] {
      n[0], n[1], 0, n[2], n[3], n[4], 0, n[5], n[6], 0, n[7], n[8], n[9], 0, n[10]
    };
  }

  /** The answer to a query; that for two disks has no time unless it is that for two spheres. */
  Reply ask(Query query) {
    double[] arguments = arguments(query);
    try {
      if (query instanceof WallQuery) {
        return reply(Part.SIDE, wallTime(arguments));
      }
      boolean pair = query instanceof PairQuery;
      int contact = (int) (pair ? pairContact : lineContact).invokeExact(arguments);
      double time = (double) (pair ? pairTime : lineTime).invokeExact(contact, arguments);
      if (pair && time != (double) sphereTime.invokeExact(inSpace(arguments))) {
        return new Reply(Part.CIRCLE, Double.NaN);
      }
      return reply(pair ? Part.CIRCLE : Falls.part(contact), time);
    } catch (ArithmeticException e) {
      return new Reply(null, Double.NaN);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }

  /** The first of the times at which a disk meets the walls that it moves towards. */
  private double wallTime(double[] n) throws Throwable {
    double[] inX = {n[0], n[2], n[3], n[3] < 0 ? n[5] : n[7], n[9]};
    double[] inY = {n[1], n[2], n[4], n[4] < 0 ? n[6] : n[8], n[9]};
    return Math.min((double) wallTime.invokeExact(inX), (double) wallTime.invokeExact(inY));
  }

  /** The time of impact of two spheres; NaN for no answer at all, as above. */
  double ask(SphereQuery query) {
    try {
      return (double) sphereTime.invokeExact(query.numbers());
    } catch (ArithmeticException e) {
      return Double.NaN;
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }

  private static Reply reply(Part part, double time) {
    return new Reply(time == Double.POSITIVE_INFINITY ? Part.NONE : part, time);
  }

  /**
   * A static method that takes doubles, perhaps an int before them.
   *
   * @param given how many it is to be given, in an array
   */
  private static MethodHandle handle(
      ClassLoader classes, Class<?> original, String name, int doubles, int given) {
    try {
      Method method = find(classes.loadClass(original.getName()), name, doubles);
      method.setAccessible(true);
      MethodHandle handle = MethodHandles.lookup().unreflect(method);
      Class<?>[] ignored = new Class<?>[given - doubles];
      Arrays.fill(ignored, double.class);
      return MethodHandles.dropArguments(handle, method.getParameterCount(), ignored)
          .asSpreader(double[].class, given);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  private static Method find(Class<?> owner, String name, int doubles) {
    return Arrays.stream(owner.getDeclaredMethods())
        .filter(method -> method.getName().equals(name))
        .filter(
            method ->
                Arrays.stream(method.getParameterTypes()).filter(double.class::equals).count()
                    == doubles)
        .findFirst()
        .orElseThrow();
  }
}
