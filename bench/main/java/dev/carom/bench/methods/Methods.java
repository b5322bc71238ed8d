// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The methods that are compared, each with the values of its knob. */
public final class Methods {

  /** This library. */
  public static final Contender CAROM = new Contender("carom", "carom", "", CaromMethod::new);

  /** The published algorithm, in float as published. */
  public static final Contender POSTER = new Contender("poster", "poster", "", FloatPoster::new);

  /** The published algorithm in double. */
  public static final Contender POSTER_DOUBLE =
      new Contender("poster-double", "poster-double", "", Poster::new);

  /** The quadratic of the textbooks in float, event-driven. */
  public static final Contender TEXTBOOK_FLOAT =
      new Contender(
          "textbook-float",
          "textbook-float",
          "",
          scene -> new FloatEventDriven(scene, new FloatTextbookDetector()).started());

  /** The quadratic of the textbooks in double, event-driven. */
  public static final Contender TEXTBOOK_DOUBLE =
      new Contender(
          "textbook-double",
          "textbook-double",
          "",
          scene -> new EventDriven(scene, new TextbookDetector()).started());

  /** The quadratic of the textbooks in double, with a grid as this library has one. */
  public static final Contender TEXTBOOK_GRID =
      new Contender(
          "textbook-grid",
          "textbook-grid",
          "",
          scene -> new GridEventDriven(scene, new TextbookDetector()).started());

  /** This library's own test in plain doubles, with its grid and without its contract. */
  public static final Contender PLAIN_GRID =
      new Contender("plain-grid", "plain-grid", "", scene -> new PlainGridMethod(scene).started());

  /** The overlap test at the end of the frame: one substep. */
  public static final Contender OVERLAP =
      new Contender("overlap", "overlap", "", scene -> parts(scene, 1));

  private static final int MOST_SUBSTEPS = 256;
  private static final int LEAST_TOLERANCE = -12;

  private Methods() {}

  /**
   * All of them. The overlap test is also the first dot of the substeps: it is listed once.
   *
   * @return in the order in which tables show them, this library first
   */
  public static List<Contender> all() {
    List<Contender> all = new ArrayList<>(List.of(CAROM, POSTER, POSTER_DOUBLE));
    all.addAll(List.of(TEXTBOOK_FLOAT, TEXTBOOK_DOUBLE, TEXTBOOK_GRID, PLAIN_GRID));
    for (int exponent = -2; exponent >= LEAST_TOLERANCE; exponent -= 2) {
      all.add(advancement(exponent));
    }
    all.add(OVERLAP);
    for (int k = 2; k <= MOST_SUBSTEPS; k *= 2) {
      all.add(substeps(k));
    }
    return List.copyOf(all);
  }

  /**
   * The overlap test at the end of each of k parts of a frame.
   *
   * @param k at least 1
   * @return the method
   */
  public static Contender substeps(int k) {
    return new Contender("substeps-" + k, "substeps", "k=" + k, scene -> parts(scene, k));
  }

  private static Method parts(Scene scene, int k) {
    return PlainScene.collides(scene) ? new CollidingSubsteps(scene, k) : new Substeps(scene, k);
  }

  /**
   * Conservative advancement with a tolerance of a power of ten, in the scene's unit of length: the
   * method.
   */
  public static Contender advancement(int exponent) {
    double tolerance = Double.parseDouble("1e" + exponent);
    return new Contender(
        String.format(Locale.ROOT, "advancement-1e%d", exponent),
        "advancement",
        String.format(Locale.ROOT, "tolerance=1e%d", exponent),
        scene -> new EventDriven(scene, new AdvancementDetector(tolerance)).started());
  }
}
