// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.reference.Truth;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.List;

/**
 * The error of one frame in units of 2^-53 times the conditioning of that frame: the sum of |d
 * position / d ln q| over the values q of the state that the frame starts from. That state is
 * rounded to doubles, so that each q is wrong by up to 2^-53 of itself, and one unit is what no
 * method can be expected to be better than. Where a frame has many impacts the error in radii says
 * little, since each of them multiplies what came before.
 */
record RoundingPart(String scene) implements Part {

  private static final List<Contender> CONTENDERS = List.of(Methods.CAROM, Methods.TEXTBOOK_DOUBLE);

  @Override
  public String id() {
    return String.join("/", "scene", scene, "roundings");
  }

  /** Each frame is proved by itself. */
  @Override
  public double seconds() {
    return 20;
  }

  @Override
  public List<Row> run() {
    Subject subject = Subjects.load(scene);
    Reference reference = subject.reference().orElseThrow();
    int circles = subject.scene().circleCount();
    double[][] units = new double[CONTENDERS.size()][subject.frames() * circles];
    for (int frame = 0; frame < subject.frames(); frame++) {
      Scene start = States.at(subject.scene(), reference, frame);
      Truth one = Truth.of(start, 1, () -> {});
      for (int k = 0; k < units.length; k++) {
        try (Method method = CONTENDERS.get(k).start(start)) {
          method.frame();
          for (int i = 0; i < circles; i++) {
            double px =
                Math.hypot(
                    method.x(i) - reference.x(frame + 1, i),
                    method.y(i) - reference.y(frame + 1, i));
            double unit = 0x1p-53 * Math.pow(10, one.log10Conditioning(1, i));
            units[k][frame * circles + i] = px / unit;
          }
        }
      }
    }
    List<Row> rows = new ArrayList<>();
    for (int k = 0; k < units.length; k++) {
      rows.addAll(rows(new Trial(scene, CONTENDERS.get(k)), new Quantiles(units[k])));
    }
    return rows;
  }

  private static List<Row> rows(Trial trial, Quantiles units) {
    int n = units.size();
    return List.of(
        trial.row("frame_roundings", "max", units.max(), Trial.ONE, n),
        trial.row("frame_roundings", "p99.9", units.at(0.999), Trial.ONE, n),
        trial.row("frame_roundings", "median", units.median(), Trial.ONE, n));
  }
}
