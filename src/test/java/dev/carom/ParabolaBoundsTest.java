// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.ExactReturn;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.ParabolaDiskSweep;
import dev.carom.internal.sweep.ParabolaReturn;
import dev.carom.internal.sweep.ParabolaSegmentSweep;
import dev.carom.internal.sweep.ParabolaWallSweep;
import dev.carom.oracle.Draw;
import dev.carom.oracle.MovingLineQuery;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.ParabolaFamilies;
import dev.carom.oracle.ParabolaFamily;
import dev.carom.oracle.ParabolaNextFamilies;
import dev.carom.oracle.ParabolaQuery;
import dev.carom.oracle.SegmentQuery;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * The rounding bounds of circles with a constant acceleration. None is violated: the ladder answers
 * as exact numbers alone do. None of those listed is idle: without it a query is answered wrongly.
 *
 * <p>More queries, and others: {@code -Dcarom.queries=1000000 -Dcarom.seed=2}.
 */
@Tag("long")
class ParabolaBoundsTest {
  private static final int QUERIES =
      (int) (Long.getLong("carom.queries", 5_500) / families().size());
  private static final long SEED = Long.getLong("carom.seed", 1);

  /** Families in which mistakes are rare and queries cheap. */
  private static final Set<String> RARE =
      Set.of("ceiling", "halfway", "halfway_side", "shallow_end", "underflow");

  /** Constants of a class, and what they are multiplied with. */
  private record Weakening(String name, String owner, double factor, List<Double> values) {}

  /** Not 0 where a condition keeps a bound of 0 from being used at all. */
  private static final double NEARLY_NONE = 0x1p-100;

  /** The bounds of the residue, of the slope and of the bend each cover much of the others. */
  private static final List<Weakening> WEAKENINGS =
      List.of(
          new Weakening("Bernstein coefficients", "GapRoot", 0, List.of(48 * 0x1p-53)),
          new Weakening("residue", "GapRoot", 0, List.of(1024 * 0x1p-106, 64 * 0x1p-53, 8.0)),
          new Weakening("underflow of a gap", "GapRoot", 0, List.of(0x1p-460)),
          new Weakening("root of a quadratic", "QuadraticRoot", 0, List.of(512 * 0x1p-106)),
          new Weakening("gap without cancellation", "DiskGap", 0, List.of(128 * 0x1p-106)),
          new Weakening("projection", "LineRegion", 0, List.of(16 * 0x1p-53)),
          new Weakening("direct hit at a rough time", "DirectHit", 0, List.of(0x1p-18)),
          new Weakening("distance from a tangent", "DirectHit", 0, List.of(0x1p-40)),
          new Weakening("near an end", "ParabolaSegmentSweep", 0, List.of(0x1p-20)),
          new Weakening(
              "discriminant of a wall", "ParabolaWallSweep", NEARLY_NONE, List.of(8 * 0x1p-53)));

  /**
   * The answer to a question.
   *
   * @param contact 0 for a miss, and for anything but a line
   */
  private record Reply(double time, int contact) {}

  @Test
  void everyBoundHoldsAndIsNeeded() {
    Map<String, Detector> without = new TreeMap<>();
    WEAKENINGS.forEach(weakening -> without.put(weakening.name(), new Detector(weakening)));
    Detector whole = new Detector(null);
    List<String> violations = new ArrayList<>();
    Map<String, String> mistakes = new TreeMap<>();
    for (ParabolaFamily family : families()) {
      Draw draw = new Draw(SEED * 0x9E3779B97F4A7C15L ^ family.name().hashCode());
      for (int i = 0; i < (RARE.contains(family.name()) ? 20 : 1) * QUERIES; i++) {
        ParabolaQuery query = family.next(draw);
        if (query.gx() == 0 && query.gy() == 0) {
          continue; // a matter of the straight sweeps
        }
        Reply truth = exact(query);
        if (!whole.ask(query).equals(truth)) {
          violations.add(family.name() + ": " + query.hex());
        }
        without.forEach(
            (name, detector) -> {
              if (!mistakes.containsKey(name) && !detector.ask(query).equals(truth)) {
                mistakes.put(name, family.name() + ": " + query.hex());
              }
            });
      }
    }
    mistakes.forEach((name, query) -> System.out.println("without " + name + ": " + query));
    assertThat(violations).isEmpty();
    assertThat(mistakes).containsOnlyKeys(without.keySet());
  }

  /** The side of a line that is left comes back, halfway between two doubles. */
  @Test
  void theBoundOfAReturnHoldsAndIsNeeded() {
    Weakening weakening =
        new Weakening("cross products", "ParabolaReturn", 0, List.of(128 * 0x1p-106));
    MethodHandle whole = new Detector(null).side;
    MethodHandle without = new Detector(weakening).side;
    ParabolaFamily family = ParabolaNextFamilies.halfwayToASide();
    Draw draw = new Draw(SEED);
    int mistakes = 0;
    for (int i = 0; i < 20 * QUERIES; i++) {
      ParabolaQuery query = family.next(draw);
      double[] a = ofLine(query);
      double truth =
          ExactReturn.toSide(1, a[3], a[4], a[5], a[6], a[7], a[8], a[9], a[10], a[11], a[12])
              .time(a[13]);
      double[] b = Arrays.copyOfRange(a, 2, 14);
      b[0] = 1;
      assertThat((double) Detector.call(whole, b)).as(query::hex).isEqualTo(truth);
      mistakes += (double) Detector.call(without, b) == truth ? 0 : 1;
    }
    assertThat(mistakes).isPositive();
  }

  private static List<ParabolaFamily> families() {
    return Stream.concat(ParabolaFamilies.all().stream(), ParabolaFamilies.ofMovingLines().stream())
        .toList();
  }

  /** A disk against a line, in the order of the sweep: velocity 0 for a line at rest. */
  private static double[] ofLine(ParabolaQuery query) {
    double[] n = query.straight().numbers();
    boolean moves = query.straight() instanceof MovingLineQuery;
    return new double[] {
      n[4],
      n[5],
      n[6],
      n[7],
      n[8],
      query.gx(),
      query.gy(),
      n[0],
      n[1],
      n[2],
      n[3],
      moves ? n[9] : 0,
      moves ? n[10] : 0,
      n[n.length - 1]
    };
  }

  private static boolean isLine(ParabolaQuery query) {
    return query.straight() instanceof SegmentQuery || query.straight() instanceof MovingLineQuery;
  }

  /** The last rung alone. */
  private static Reply exact(ParabolaQuery query) {
    double[] n = query.straight().numbers();
    double gx = query.gx();
    double gy = query.gy();
    if (isLine(query)) {
      double[] a = ofLine(query);
      ExactParabola line =
          ExactParabola.line(
              a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8], a[9], a[10], a[11], a[12]);
      return reply(line, line.first(a[13]), n[0] == n[2] && n[1] == n[3]);
    }
    if (query.straight() instanceof PairQuery) {
      double time =
          ExactParabola.disk(n[0], n[1], n[2], n[3], n[4], gx, gy, n[5], n[6], n[7], n[8], n[9])
              .time(n[10]);
      return new Reply(time, 0);
    }
    double left = ExactParabola.wall(n[0], n[2], n[3], gx, n[5], 1).time(n[9]);
    double right = ExactParabola.wall(n[0], n[2], n[3], gx, n[7], -1).time(n[9]);
    double bottom = ExactParabola.wall(n[1], n[2], n[4], gy, n[6], 1).time(n[9]);
    double top = ExactParabola.wall(n[1], n[2], n[4], gy, n[8], -1).time(n[9]);
    return new Reply(Math.min(Math.min(left, right), Math.min(bottom, top)), 0);
  }

  private static Reply reply(ExactParabola line, RealRoot root, boolean isPoint) {
    double time = root == null ? Double.POSITIVE_INFINITY : root.nearest();
    if (time == Double.POSITIVE_INFINITY) {
      return new Reply(time, 0);
    }
    int now = time == 0 ? Contact.NOW : 0;
    int region = line.region(root);
    int side = region == 0 && line.side(root) > 0 ? Contact.LEFT : Contact.RIGHT;
    int part = isPoint || region < 0 ? Contact.START : region > 0 ? Contact.END : side;
    return new Reply(time, part | now);
  }

  /** A copy of the sweeps, with the constants of one weakening replaced. */
  private static final class Detector {
    private final MethodHandle line;
    private final MethodHandle contact;
    private final MethodHandle disk;
    private final MethodHandle wall;
    private final MethodHandle side;

    Detector(Weakening weakening) {
      ClassLoader classes = new PatchedClasses((name, pool) -> weaken(weakening, name, pool));
      line = handle(classes, ParabolaSegmentSweep.class, "time", 14);
      contact = handle(classes, ParabolaSegmentSweep.class, "contact", 14);
      disk = handle(classes, ParabolaDiskSweep.class, "time", 13);
      wall = handle(classes, ParabolaWallSweep.class, "time", 7);
      side = handle(classes, ParabolaReturn.class, "toSide", 12);
    }

    Reply ask(ParabolaQuery query) {
      double[] n = query.straight().numbers();
      double gx = query.gx();
      double gy = query.gy();
      if (isLine(query)) {
        double[] arguments = ofLine(query);
        double time = (double) call(line, arguments);
        arguments[13] = time;
        boolean hit = time < Double.POSITIVE_INFINITY;
        return new Reply(time, hit ? (int) call(contact, arguments) : 0);
      }
      if (query.straight() instanceof PairQuery) {
        double time =
            (double)
                call(
                    disk, n[0], n[1], n[2], n[3], n[4], gx, gy, n[5], n[6], n[7], n[8], n[9],
                    n[10]);
        return new Reply(time, 0);
      }
      double left = (double) call(wall, n[0], n[2], n[3], gx, n[5], 1, n[9]);
      double right = (double) call(wall, n[0], n[2], n[3], gx, n[7], -1, n[9]);
      double bottom = (double) call(wall, n[1], n[2], n[4], gy, n[6], 1, n[9]);
      double top = (double) call(wall, n[1], n[2], n[4], gy, n[8], -1, n[9]);
      return new Reply(Math.min(Math.min(left, right), Math.min(bottom, top)), 0);
    }

    private static Object call(MethodHandle sweep, double... arguments) {
      try {
        Object[] boxed = new Object[arguments.length];
        for (int i = 0; i < boxed.length; i++) {
          boolean isInt = sweep.type().parameterType(i) == int.class;
          boxed[i] = isInt ? (Object) (int) arguments[i] : (Object) arguments[i];
        }
        return sweep.invokeWithArguments(boxed);
      } catch (RuntimeException | Error e) {
        throw e;
      } catch (Throwable e) {
        throw new IllegalStateException(e);
      }
    }

    /** Nothing is weakened if the weakening is null. */
    private static void weaken(Weakening weakening, String className, ConstantPool pool) {
      if (weakening != null && className.endsWith("." + weakening.owner())) {
        for (double value : weakening.values()) {
          pool.replace(value, value * weakening.factor());
        }
      }
    }

    private static MethodHandle handle(
        ClassLoader classes, Class<?> original, String name, int arguments) {
      try {
        for (Method method : classes.loadClass(original.getName()).getDeclaredMethods()) {
          if (method.getName().equals(name) && method.getParameterCount() == arguments) {
            return MethodHandles.lookup().unreflect(method);
          }
        }
        throw new IllegalStateException(original.getName());
      } catch (ReflectiveOperationException e) {
        throw new IllegalStateException(e);
      }
    }
  }
}
