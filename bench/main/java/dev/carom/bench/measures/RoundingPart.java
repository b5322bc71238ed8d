// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.reference.RoundedPlaces;
import dev.carom.bench.reference.Truth;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The error of one frame in units of 2^-53 times the conditioning of that frame: the sum of |d
 * position / d ln q| over the values q of the state that the frame starts from. That state is
 * rounded to doubles, so that each q is wrong by up to 2^-53 of itself, and one unit is what no
 * method can be expected to be better than. Where a frame has many impacts the error in radii says
 * little, since each of them multiplies what came before.
 *
 * <p>By circle, each has the conditioning of its own course; by frame, the greatest error of all
 * circles stands against the greatest conditioning.
 *
 * @param scene its name
 */
public record RoundingPart(String scene) implements Part {

  /** The metric of its rows. */
  public static final String METRIC = "frame_roundings";

  /** The limit to be kept, in units. */
  public static final double LIMIT = 4;

  /** The stat of how many circle-frames are above the limit. */
  public static final String ABOVE = "above limit";

  /** The stat of the greatest of all frames, each with its greatest conditioning. */
  public static final String OF_FRAMES = "max of frames";

  /** The stat of the impacts of the worst circle in its frame. */
  public static final String IMPACTS = "impacts of worst";

  /** The stat of the error there of exact motion whose places are rounded at each impact. */
  public static final String ROUNDED = "rounded places";

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
    int circles = subject.scene().count(Kind.CIRCLE);
    List<Roundings> all = new ArrayList<>();
    CONTENDERS.forEach(none -> all.add(new Roundings(subject.frames(), circles)));
    for (int frame = 0; frame < subject.frames(); frame++) {
      Scene start = States.at(subject.scene(), reference, frame);
      double[] unit = units(Truth.of(start, 1, () -> {}));
      for (int k = 0; k < all.size(); k++) {
        all.get(k).add(frame, errors(CONTENDERS.get(k), start, reference, frame + 1), unit);
      }
    }
    List<Row> rows = new ArrayList<>();
    for (int k = 0; k < all.size(); k++) {
      Trial trial = new Trial(scene, CONTENDERS.get(k));
      rows.addAll(all.get(k).rows(trial));
      rows.addAll(
          worst(
              trial,
              subject.scene(),
              reference,
              all.get(k).worstFrame(),
              all.get(k).worstCircle()));
    }
    return rows;
  }

  private static double[] units(Truth one) {
    double[] units = new double[one.circles()];
    Arrays.setAll(units, i -> 0x1p-53 * Math.pow(10, one.log10Conditioning(1, i)));
    return units;
  }

  private static double[] errors(Contender contender, Scene start, Reference reference, int end) {
    double[] px = new double[start.count(Kind.CIRCLE)];
    try (Method method = contender.start(start)) {
      method.frame();
      Arrays.setAll(
          px,
          i -> Math.hypot(method.x(i) - reference.x(end, i), method.y(i) - reference.y(end, i)));
    }
    return px;
  }

  /** Explains the worst error: the number of impacts, and the cost of rounding their places. */
  private static List<Row> worst(
      Trial trial, Scene scene, Reference reference, int frame, int circle) {
    Scene start = States.at(scene, reference, frame);
    Truth one = Truth.of(start, 1, () -> {});
    Vec2 rounded = RoundedPlaces.end(start, circle, 1);
    double px =
        Math.hypot(
            rounded.x() - reference.x(frame + 1, circle),
            rounded.y() - reference.y(frame + 1, circle));
    return List.of(
        trial.row(METRIC, IMPACTS, one.impacts(circle), Trial.ONE, 1),
        trial.row(METRIC, ROUNDED, px / units(one)[circle], Trial.ONE, 1));
  }
}
