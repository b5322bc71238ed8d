// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.Gaps;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.FallSweep;
import dev.carom.internal.sweep.Falls;
import dev.carom.internal.sweep.ParabolaWallSweep;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Family;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.ParabolaContact;
import dev.carom.oracle.ParabolaFamilies;
import dev.carom.oracle.ParabolaNextFamilies;
import dev.carom.oracle.ParabolaQuery;
import dev.carom.oracle.Query;
import dev.carom.oracle.SegmentQuery;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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

  private static final List<Weakening> WEAKENINGS =
      List.of(
          new Weakening(
              "signs on an interval", "GapPolynomial", 0, List.of(16 * 0x1p-53, 9 * 0x1p-53)),
          new Weakening("values in double-double", "GapPolynomial", 0, List.of(160 * 0x1p-106)),
          new Weakening("least size", "GapPolynomial", 0, List.of(0x1p-900)),
          new Weakening("beside a root", "GapRoot", 0, List.of(2560.0)),
          new Weakening("projection", "Fall", 0, List.of(16 * 0x1p-53)),
          new Weakening("distance from a tangent", "DirectHit", 0, List.of(0x1p-40)),
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
    Detector whole = Detector.whole();
    List<String> violations = new ArrayList<>();
    Map<String, String> mistakes = new TreeMap<>();
    for (Family<ParabolaQuery> family : families()) {
      Draw draw = Draw.of(SEED, family.name());
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
    Weakening weakening = new Weakening("beside a root", "GapRoot", 0, List.of(2560.0));
    MethodHandle whole = Detector.whole().side;
    MethodHandle without = new Detector(weakening).side;
    Family<ParabolaQuery> family = ParabolaNextFamilies.halfwayToASide();
    Draw draw = new Draw(SEED);
    int mistakes = 0;
    for (int i = 0; i < 20 * QUERIES; i++) {
      ParabolaQuery query = family.next(draw);
      double[] b = Arrays.copyOfRange(query.numbers(query.end()), 2, 14);
      b[0] = 1;
      double truth = Falls.exactReturnToSide(b);
      assertThat((double) Detector.call(whole, b)).as(query::hex).isEqualTo(truth);
      mistakes += (double) Detector.call(without, b) == truth ? 0 : 1;
    }
    assertThat(mistakes).isPositive();
  }

  /** A disk flies up along the rim of another one, and falls back: there all is rounding. */
  @Test
  void theLeastSpeedOfAReturnHoldsAndIsNeeded() {
    MethodHandle whole = Detector.whole().rim;
    MethodHandle without = detector("DirectHit", 0x1p-24, 0).rim;
    MethodHandle late = detector("DirectHit", 1 - 0x1p-20, 1).rim; // costs time only
    SplittableRandom random = new SplittableRandom(SEED);
    int mistakes = 0;
    for (int i = 0; i < 4 * QUERIES; i++) {
      double x = random.nextDouble(-1, 1);
      double y = random.nextDouble(-1, 1);
      double k = random.nextDouble(-1, 1);
      double pull = random.nextDouble();
      double[] n = {x, y, -k * y, k * x, pull * k * y, -pull * k * x, 0, 0, 0, 0, 100};
      double truth = Falls.exactReturnToDisk(n);
      assertThat((double) Detector.call(whole, n)).isEqualTo(truth);
      assertThat((double) Detector.call(late, n)).isEqualTo(truth);
      mistakes += (double) Detector.call(without, n) == truth ? 0 : 1;
    }
    assertThat(mistakes).isPositive();
  }

  /**
   * Constants that cost time only: others send more questions to exact numbers, and none is
   * answered wrongly.
   */
  @Test
  void whatALaterCheckCatchesCostsTimeOnly() {
    Map<String, Detector> others = new TreeMap<>();
    others.put("the end of a fall as computed", detector("FallSweep", 1.001, 1));
    others.put("wide intervals only", detector("GapSearch", 0x1p-44, 0x1p-10));
    others.put("a search from just before an entry", detector("GapSearch", 1 - 0x1p-20, 1));
    others.put("a long first part of a flight", detector("DirectHit", 0x1p-5, 1));
    others.put("a wide margin", new Detector((name, pool) -> margin(0x1p-10, name, pool)));
    others.put("a narrow margin", new Detector((name, pool) -> margin(0x1p-30, name, pool)));
    for (Family<ParabolaQuery> family : families()) {
      Draw draw = Draw.of(SEED, family.name());
      for (int i = 0; i < QUERIES / 20; i++) {
        ParabolaQuery query = family.next(draw);
        if (query.gx() == 0 && query.gy() == 0) {
          continue;
        }
        Reply truth = exact(query);
        others.forEach(
            (name, detector) ->
                assertThat(detector.ask(query)).as(name + ": " + query.hex()).isEqualTo(truth));
      }
    }
  }

  /** Another margin around roots, with all that is derived from it. */
  private static void margin(double margin, String className, ConstantPool pool) {
    if (className.endsWith(".GapRoot")) {
      pool.replace(0x1p-20, margin);
      pool.replace(0.5 * 0x1p-20, 0.5 * margin);
    }
    if (className.endsWith(".DirectHit")) {
      pool.replace(4 * 0x1p-20, 4 * margin);
    }
  }

  /** Of a normal: the error of the time, and the range of the numbers without exact ones. */
  @ParameterizedTest
  @CsvSource({
    "circ_fast, FallSweep, 0x1p-55, 0x1p1000",
    "circ_extreme_magnitude, UnitVectors, 0x1p-400, 0",
    "scaled, UnitVectors, 0x1p400, 0x1p1000"
  })
  void theBoundsOfANormalHoldAndAreNeeded(String name, String owner, double from, double to)
      throws ReflectiveOperationException {
    Detector whole = Detector.whole();
    Detector without = detector(owner, from, to);
    Family<ParabolaQuery> family =
        families().stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow();
    Draw draw = new Draw(SEED);
    int mistakes = 0;
    for (int i = 0; i < 3 * QUERIES; i++) {
      ParabolaQuery query = family.next(draw);
      ParabolaContact truth = query.truth();
      if (query.straight() instanceof PairQuery && truth.time() < Double.POSITIVE_INFINITY) {
        assertThat(whole.errorOfNormal(query, truth)).as(query::hex).isLessThan(1e-15);
        mistakes += without.errorOfNormal(query, truth) < 1e-15 ? 0 : 1;
      }
    }
    assertThat(mistakes).isPositive();
  }

  /** What a search answered wrongly once one of its bounds was left out: of disks, of a line. */
  @ParameterizedTest(name = "{0}")
  @CsvSource(
      delimiter = '|',
      value = {
        "time to the fourth power lifts underflow above all bounds | 0x1.0de6b71c010edp7 "
            + "0x1.bbb5de00016c4p6 0x1.f8p6 0x1.d8ca471ff7896p-370 -0x1.f6d7780005b1p-370 "
            + "-0x1.4cp6 0x1.1cp6 0x1.f8p6 -0x1.2p-372 -0x1.0p-375 0x1.0p375 "
            + "-0x1.1065238ffbc4bp-744 0x1.5ed7780005b1p-745",
        "a strip so thin that all is lost to underflow | 0 0 -0x1.0p-143 0x1.2p-142 "
            + "-0x1.f5ap-133 -0x1.028853829d706p-135 0x1.a78p-136 0x1.cp-143 "
            + "0x1.1544528450d47p-143 0x1.93e5939a08ceap99 0 -0x1.cfd4c9ff570a4p-153",
        "taken over an end by gravity, both gaps within rounding | "
            + "0 0 0x1.96cf7ceea1719p1 0x1.08351117f3bedp-4 -0x1.160edb7657318p-5 "
            + "0x1.ac12c320cdd18p0 0x1.ac295632ea9ebp0 0x1.4c748a7842193p-6 -0x1.ffe503622a4f3p-1 "
            + "0x1.471e3d3857283p-45 0x1.9f4dade20fb1bp92 0x1.0db91e2641b38p87"
      })
  void whatOnceWasWrongIsTrue(String what, String numbers) {
    double[] all = Stream.of(numbers.split(" ")).mapToDouble(Double::parseDouble).toArray();
    int size = all.length - 2;
    double[] n = Arrays.copyOf(all, size);
    Query straight = size == 11 ? PairQuery.of(n) : SegmentQuery.of(n);
    ParabolaQuery query = new ParabolaQuery(straight, all[size], all[size + 1]);
    assertThat(Detector.whole().ask(query)).isEqualTo(exact(query));
  }

  /**
   * A disk that comes slowly upon the side beside an end, with its centre hardly beside the line.
   */
  @Test
  void theBoundOfARoughTimeIsNeeded() {
    double[] n = {
      0,
      0x1.8p2,
      -0x1.4d6388826f313p0,
      0x1.ae4a869608c8cp2,
      -0x1.6622297e069dbp1,
      0x1.8b0a8aac2b73ep2,
      0x1.351929c704ba4p0,
      0x1.e6b4ef09d74adp-1,
      -0x1.0dfda66d2de53p-1,
      2
    };
    ParabolaQuery query =
        new ParabolaQuery(SegmentQuery.of(n), 0x1.8b4ebc53adfacp-10, -0x1.8a6f097b9f403p-10);
    assertNeeded(query, detector("DirectHit", 0x1p-18, 0));
  }

  private static void assertNeeded(ParabolaQuery query, Detector without) {
    assertThat(Detector.whole().ask(query)).isEqualTo(exact(query));
    assertThat(without.ask(query)).isNotEqualTo(exact(query));
  }

  private static Detector detector(String owner, double from, double to) {
    return new Detector(
        (name, pool) -> {
          if (name.endsWith("." + owner)) {
            pool.replace(from, to);
          }
        });
  }

  private static List<Family<ParabolaQuery>> families() {
    return Stream.concat(ParabolaFamilies.all().stream(), ParabolaFamilies.ofMovingLines().stream())
        .toList();
  }

  /** The last rung alone. */
  private static Reply exact(ParabolaQuery query) {
    double[] n = query.straight().numbers();
    double gx = query.gx();
    double gy = query.gy();
    if (query.isOfLine()) {
      double[] a = query.numbers(query.end());
      ExactParabola line = FallSweep.exact(Falls.line(a));
      return reply(line, line.first(a[13]), n[0] == n[2] && n[1] == n[3]);
    }
    if (query.straight() instanceof PairQuery) {
      double time = FallSweep.exact(Falls.disk(query.numbers())).time(n[10]);
      return new Reply(time, 0);
    }
    double left = ParabolaWallSweep.exact(n[0], n[2], n[3], gx, n[5], 1).time(n[9]);
    double right = ParabolaWallSweep.exact(n[0], n[2], n[3], gx, n[7], -1).time(n[9]);
    double bottom = ParabolaWallSweep.exact(n[1], n[2], n[4], gy, n[6], 1).time(n[9]);
    double top = ParabolaWallSweep.exact(n[1], n[2], n[4], gy, n[8], -1).time(n[9]);
    return new Reply(Math.min(Math.min(left, right), Math.min(bottom, top)), 0);
  }

  private static Reply reply(ExactParabola line, RealRoot root, boolean isPoint) {
    double time = root == null ? Double.POSITIVE_INFINITY : root.nearest();
    if (time == Double.POSITIVE_INFINITY) {
      return new Reply(time, 0);
    }
    int now = time == 0 ? Contact.NOW : 0;
    int region = line.region(root);
    int side = region == Gaps.BESIDE && line.side(root) > 0 ? Contact.LEFT : Contact.RIGHT;
    int part =
        isPoint || region == Gaps.BEFORE
            ? Contact.START
            : region == Gaps.BEYOND ? Contact.END : side;
    return new Reply(time, part | now);
  }

  /** A copy of the sweeps, with the constants of one weakening replaced. */
  private static final class Detector {
    private final MethodHandle line;
    private final MethodHandle contact;
    private final MethodHandle disk;
    private final MethodHandle wall;
    private final MethodHandle side;
    private final MethodHandle rim;
    private final MethodHandle normal;

    static Detector whole() {
      return new Detector((name, pool) -> {});
    }

    Detector(Weakening weakening) {
      this((name, pool) -> weaken(weakening, name, pool));
    }

    Detector(BiConsumer<String, ConstantPool> patch) {
      ClassLoader classes = new PatchedClasses(patch);
      line = handle(classes, Falls.class, "timeOfLine", 1);
      contact = handle(classes, Falls.class, "contact", 1);
      disk = handle(classes, Falls.class, "timeOfDisk", 1);
      wall = handle(classes, ParabolaWallSweep.class, "time", 7);
      side = handle(classes, Falls.class, "returnToSide", 1);
      rim = handle(classes, Falls.class, "returnToDisk", 1);
      normal = handle(classes, Falls.class, "normal", 1);
    }

    /** Of a hit on a disk; 0 if the normal is left to exact numbers. */
    double errorOfNormal(ParabolaQuery query, ParabolaContact truth)
        throws ReflectiveOperationException {
      Object unit = call(normal, query.numbers(truth.time()));
      if (unit == null) {
        return 0;
      }
      double x = (double) unit.getClass().getMethod("x").invoke(unit);
      double y = (double) unit.getClass().getMethod("y").invoke(unit);
      double error =
          Math.max(
              Math.abs(x - truth.normal().x().near()), Math.abs(y - truth.normal().y().near()));
      return Double.isNaN(error) ? Double.POSITIVE_INFINITY : error;
    }

    Reply ask(ParabolaQuery query) {
      double[] n = query.straight().numbers();
      double gx = query.gx();
      double gy = query.gy();
      if (query.isOfLine()) {
        double time = (double) call(line, query.numbers(query.end()));
        boolean hit = time < Double.POSITIVE_INFINITY;
        return new Reply(time, hit ? (int) call(contact, query.numbers(time)) : 0);
      }
      if (query.straight() instanceof PairQuery) {
        return new Reply((double) call(disk, query.numbers(query.end())), 0);
      }
      double left = (double) call(wall, n[0], n[2], n[3], gx, n[5], 1, n[9]);
      double right = (double) call(wall, n[0], n[2], n[3], gx, n[7], -1, n[9]);
      double bottom = (double) call(wall, n[1], n[2], n[4], gy, n[6], 1, n[9]);
      double top = (double) call(wall, n[1], n[2], n[4], gy, n[8], -1, n[9]);
      return new Reply(Math.min(Math.min(left, right), Math.min(bottom, top)), 0);
    }

    private static Object call(MethodHandle sweep, double... arguments) {
      try {
        if (sweep.type().parameterCount() == 1) {
          return sweep.invokeWithArguments((Object) arguments);
        }
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
      return handle(classes, original.getName(), name, arguments);
    }

    private static MethodHandle handle(
        ClassLoader classes, String owner, String name, int arguments) {
      try {
        for (Method method : classes.loadClass(owner).getDeclaredMethods()) {
          if (method.getName().equals(name) && method.getParameterCount() == arguments) {
            method.setAccessible(true);
            return MethodHandles.lookup().unreflect(method).asFixedArity();
          }
        }
        throw new IllegalStateException(owner);
      } catch (ReflectiveOperationException e) {
        throw new IllegalStateException(e);
      }
    }
  }
}
