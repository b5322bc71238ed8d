// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.duel;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.PlainScene;
import dev.carom.bench.reference.Reference;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * This library and a rival that play the same scene from the same moment. Any frame can be asked
 * for, those before again: what was played is kept. For one thread; to be closed.
 */
public final class Duel implements AutoCloseable {

  /** Lines of a score. */
  public static final int LINES = 5;

  /** In radii: deeper is bad. */
  private static final double DEEP = 0.01;

  /** In radii: farther from where it should be is bad. */
  private static final double FAR = 0.1;

  /** A difference of the energy from that of this library that is bad. */
  private static final double WRONG_ENERGY = 0.01;

  private static final double WARM_UP_NANOS = 3e8;

  private final Scene scene;
  private final Rival rival;
  private final Reference truth;
  private final boolean judges;
  private final Contestant carom;
  private final Contestant other;

  /**
   * Starts a duel.
   *
   * @param scene the scene at frame 0
   * @param rival the method that plays it, too
   * @param truth its true course; null if that is not known
   */
  public Duel(Scene scene, Rival rival, Reference truth) {
    this.scene = scene;
    this.rival = rival;
    this.truth = truth;
    judges = PlainScene.isAtRest(scene);
    carom = new Contestant(Rival.carom(), scene);
    other = new Contestant(rival.contender(), scene);
  }

  /**
   * Plays a scene by both for a moment, so that the virtual machine compiles them: otherwise the
   * first seconds would time its interpreter.
   *
   * @param rival the method that plays it, too
   */
  public static void warmUp(Scene scene, Rival rival) {
    for (Contender contender : List.of(Rival.carom(), rival.contender())) {
      long end = System.nanoTime() + (long) WARM_UP_NANOS;
      boolean plays = true;
      while (plays && System.nanoTime() < end) {
        try (Contestant contestant = new Contestant(contender, scene)) {
          for (int frame = 0; frame < Preset.FRAMES && System.nanoTime() < end; frame++) {
            contestant.at(frame);
          }
          plays = contestant.failure(0).isEmpty();
        }
      }
    }
  }

  /** The scene at frame 0. */
  public Scene scene() {
    return scene;
  }

  /** The rival of this library. */
  public Rival rival() {
    return rival;
  }

  /**
   * The state of this library's circles.
   *
   * @param frame the number of the frame, 0 for the start
   * @return the circles at its end
   */
  public PlayedFrame carom(int frame) {
    return carom.at(frame);
  }

  /**
   * The state of the rival's circles.
   *
   * @param frame the number of the frame, 0 for the start
   * @return the circles at its end; those of the last frame before it failed, if it did
   */
  public PlayedFrame rival(int frame) {
    return other.at(frame);
  }

  /**
   * The score of this library.
   *
   * @param frame the number of the frame, 0 for the start
   * @return lines of text; a single one where obstacles move, among which nothing is judged
   */
  public List<ScoreLine> caromScore(int frame) {
    return judges
        ? score(carom(frame), frame, isKnown(frame))
        : List.of(new ScoreLine("not judged: lines or pegs of this scene move", false));
  }

  /**
   * The score of the rival. Its error is that against the truth, or, where that is not known,
   * against this library; the line says which.
   *
   * @param frame the number of the frame, 0 for the start
   * @return lines of text
   */
  public List<ScoreLine> rivalScore(int frame) {
    PlayedFrame played = rival(frame);
    Optional<String> failure = other.failure(frame);
    return failure.isPresent()
        ? List.of(new ScoreLine("does not play: " + failure.get(), true))
        : score(played, frame, true);
  }

  private boolean isKnown(int frame) {
    return truth != null && frame <= truth.frames();
  }

  private List<ScoreLine> score(PlayedFrame played, int frame, boolean compared) {
    return List.of(
        new ScoreLine("lost: " + played.lost() + " of " + played.circles(), played.lost() > 0),
        new ScoreLine(
            "deepest overlap: " + number(played.penetration()) + " radii",
            played.penetration() > DEEP),
        energy(played, frame),
        compared
            ? error(played, frame)
            : new ScoreLine("error: the truth is not known here", false),
        new ScoreLine(
            Double.isNaN(played.micros())
                ? "time: no frame yet"
                : "time: " + number(played.micros()) + " µs a frame",
            false));
  }

  private ScoreLine energy(PlayedFrame played, int frame) {
    if (Double.isNaN(played.energy())) {
      boolean deep = scene.bounds().isEmpty() && !PlainScene.isStraight(scene);
      String why = deep ? "not judged, a fall without bounds has no end" : "none at the start";
      return new ScoreLine("energy: " + why, false);
    }
    String text = String.format(Locale.ROOT, "energy: %.2f %%", 100 * played.energy());
    double difference = Math.abs(played.energy() - carom(frame).energy());
    return new ScoreLine(text, difference > WRONG_ENERGY);
  }

  private ScoreLine error(PlayedFrame played, int frame) {
    double[] errors = errors(played, frame);
    double worst = errors[errors.length - 1];
    String whom = isKnown(frame) ? "the truth" : "Carom";
    String median = number(errors[(errors.length - 1) / 2]);
    return new ScoreLine(
        "error against " + whom + ": " + number(worst) + " radii, median " + median, worst > FAR);
  }

  /**
   * The distance of each circle from where it should be.
   *
   * @param frame the number of that frame
   * @return in radii, ascending; infinite for a circle at no place
   */
  double[] errors(PlayedFrame played, int frame) {
    PlayedFrame own = carom(frame);
    double[] errors = new double[Math.max(1, played.circles())];
    for (int i = 0; i < played.circles(); i++) {
      double x = isKnown(frame) ? truth.x(frame, i) : own.x(i);
      double y = isKnown(frame) ? truth.y(frame, i) : own.y(i);
      double error =
          Math.hypot(played.x(i) - x, played.y(i) - y)
              / ((Circle) scene.shape(Kind.CIRCLE, i)).radius();
      errors[i] = Double.isNaN(error) ? Double.POSITIVE_INFINITY : error;
    }
    Arrays.sort(errors);
    return errors;
  }

  /** Two or three digits; what is tiny by its power of ten. */
  private static String number(double x) {
    if (x == 0 || Double.isInfinite(x)) {
      return x == 0 ? "0" : "infinitely many";
    }
    String format = x < 0.01 ? "%.0e" : x < 10 ? "%.2f" : x < 100 ? "%.1f" : "%,.0f";
    return String.format(Locale.ROOT, format, x).replace("e-0", "e-");
  }

  @Override
  public void close() {
    carom.close();
    other.close();
  }
}
