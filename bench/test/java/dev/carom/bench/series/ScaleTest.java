// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.experiment.Tiles;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.ScalePlan.Model;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.util.List;
import org.junit.jupiter.api.Test;

class ScaleTest {

  @Test
  void thePlanGoesFromAHundredToAMillion() {
    assertThat(ScalePlan.of(1_000_000, false, 1000, 1).sides()).startsWith(1).endsWith(100);
    assertThat(ScalePlan.of(500, false, 1000, 1).sides()).containsExactly(1, 2);
    assertThat(ScalePlan.of(1_000_000, true, 1000, 1).sides()).containsExactly(1, 2, 3);
  }

  @Test
  void tilesAreAsDenseAsTheExperiment() throws CannotPlaceException {
    assertThat(new Tiles(1, true, 5).scene()).isEqualTo(Crosses.canonical(5).scene());
    Scene four = new Tiles(2, true, 5).scene();
    assertThat(four.count(Kind.CIRCLE)).isEqualTo(400);
    assertThat(four.count(Kind.LINE)).isEqualTo(400);
    assertThat(four.bounds().orElseThrow().xmax()).isEqualTo(1600);
    Scene last = Crosses.canonical(8).scene();
    assertThat(((Circle) four.shape(Kind.CIRCLE, 399)).x())
        .isEqualTo(((Circle) last.shape(Kind.CIRCLE, 99)).x() + 800);
    assertThat(((Circle) four.shape(Kind.CIRCLE, 399)).y())
        .isEqualTo(((Circle) last.shape(Kind.CIRCLE, 99)).y() + 600);
    assertThat(new Tiles(2, false, 5).scene().count(Kind.LINE)).isZero();
  }

  /** A method that waits before each frame. */
  private static Method slow(Method method, int millis) {
    InvocationHandler handler =
        (proxy, called, arguments) -> {
          if (called.getName().equals("frame")) {
            Thread.sleep(millis);
          }
          return called.invoke(method, arguments);
        };
    return (Method)
        Proxy.newProxyInstance(
            Method.class.getClassLoader(), new Class<?>[] {Method.class}, handler);
  }

  @Test
  void whoTakesTooLongIsToldAndPlaysNoLargerScene() throws CannotPlaceException {
    Contender slow =
        new Contender("slow", "slow", "", scene -> slow(Methods.CAROM.start(scene), 20));
    List<Row> rows =
        new Scale(new ScalePlan(List.of(1, 2), 1, 1, 0, 10, 1), 1)
            .run(Model.ALONE, List.of(slow), () -> {});

    assertThat(rows)
        .singleElement()
        .satisfies(
            row -> {
              assertThat(row.scene()).isEqualTo("scale:alone=100");
              assertThat(row.stat()).isEqualTo(Scale.TIMED_OUT);
              assertThat(row.value()).isGreaterThan(10e6);
            });
  }

  /**
   * The heap gives large arrays whole regions: what a circle takes is told by many of them only.
   */
  @Test
  void aWorldTakesWhatItsArraysTake() throws CannotPlaceException {
    Footprint memory = Footprint.of(18, 1);
    int n = 32_400;
    assertThat(memory.circles()).isEqualTo(n);
    // 11 doubles, 5 ints, and when it is due.
    double least = 11 * Double.BYTES + 5 * Integer.BYTES + Long.BYTES;
    // A reference to its grid; up to a region of 1 MB more for each of 4 arrays, and 1 MB of logs.
    double most = least + Integer.BYTES + 5.0 * (1 << 20) / n;
    assertThat(memory.perCircle()).isBetween(least, most);
    // About two cells, and what is listed in them.
    assertThat(memory.perLine()).isBetween(8.0, 8 + 4.0 * (1 << 20) / n);
  }
}
