// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/**
 * What circles cost that fall on each other until they rest, and what balls cost that fall among
 * pegs. Each scene is played several times, in 60 frames a second. All plays make the same impacts:
 * the time of a frame is its median over them.
 */
public final class Heaps {

  /** The metric of the time that one simulated second takes. */
  public static final String SECOND = "heap_second";

  /** The metric of the times of a frame. */
  public static final String FRAME = "heap_frame";

  /** The metric of the impacts in a simulated second. */
  public static final String IMPACTS = "heap_impacts";

  /** The metric of the share of circles that rest at the end. */
  public static final String RESTING = "heap_resting";

  /** The prefix of the names of heaps, before the number of circles. */
  public static final String HEAP = "heap:";

  /** The name of the scene of balls among pegs. */
  public static final String PLINKO = "plinko";

  private static final int[] SIZES = {10, 30, 100, 1_000};
  private static final int FRAMES_A_SECOND = 60;

  private static final int HEAP_SECONDS = 6;
  private static final int PLINKO_SECONDS = 15;
  private static final int BALLS = 50;
  private static final double PEG_SPACING = 40 / 15.0;

  /** A scene, and how many frames of it are played. */
  private record Pile(String name, Scene scene, int frames) {

    /** Plays it, and keeps the times of its frames. */
    Play play(double[] nanos) {
      World world = new World(scene);
      long impacts = 0;
      for (int frame = 0; frame < frames; frame++) {
        double end = (frame + 1.0) / FRAMES_A_SECOND;
        long start = System.nanoTime();
        world.advanceTo(end);
        impacts += world.impacts().size();
        nanos[frame] = System.nanoTime() - start;
      }
      int resting = 0;
      for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
        resting += world.isResting(i) ? 1 : 0;
      }
      return new Play(impacts, (double) resting / world.count(Kind.CIRCLE));
    }
  }

  /** What a play made: its impacts, and the share of circles that rest at its end. */
  private record Play(long impacts, double resting) {}

  private final List<Pile> piles = new ArrayList<>();

  /**
   * Prepares the scenes.
   *
   * @param most the most circles in a heap
   * @param seed of their places
   */
  public Heaps(int most, long seed) {
    piles.add(new Pile(PLINKO, plinko(seed), PLINKO_SECONDS * FRAMES_A_SECOND));
    Arrays.stream(SIZES)
        .filter(n -> n <= most)
        .forEach(n -> piles.add(new Pile(HEAP + n, heap(n, seed), HEAP_SECONDS * FRAMES_A_SECOND)));
  }

  /** Circles of radius 1 in a box, about as high as wide; they begin in rows above each other. */
  private static Scene heap(int circles, long seed) {
    int columns = (int) Math.ceil(Math.sqrt(circles));
    SceneBuilder builder = Scene.builder().gravity(0, -10);
    builder.bounds(0, 0, 2.4 * columns + 0.7, 3.0 * columns + 10);
    Random random = new Random(seed);
    for (int i = 0; i < circles; i++) {
      double x = 1.2 + 2.4 * (i % columns) + 0.3 * random.nextDouble();
      int row = i / columns;
      builder.circle(x, 2 + 3.0 * row, 1, 0, 0).restitution(0.5);
    }
    return builder.build();
  }

  /** 203 pegs between two walls; the balls fall out below. */
  private static Scene plinko(long seed) {
    SceneBuilder builder = Scene.builder().gravity(0, -10);
    builder.line(0, -2, 0, 99).line(40, -2, 40, 99);
    for (int row = 0; row < 14; row++) {
      for (int i = 0; i < 14 + row % 2; i++) {
        builder.peg((i + (row % 2 == 0 ? 1 : 0.5)) * PEG_SPACING, 4 + row * 2.6, 0.3);
      }
    }
    Random random = new Random(seed);
    for (int i = 0; i < BALLS; i++) {
      double x = 2 + 4 * (i % 10) + 0.4 * random.nextDouble();
      int row = i / 10;
      builder.circle(x, 45 + 2.5 * row, 0.5, 0, 0).restitution(0.5);
    }
    return builder.build();
  }

  /**
   * Measures.
   *
   * @param rounds in which each scene is played
   * @param warmUpMillis how long each is played before
   */
  public List<Row> run(int rounds, int warmUpMillis) {
    List<Row> rows = new ArrayList<>();
    for (Pile pile : piles) {
      double[][] nanos = new double[rounds][pile.frames];
      Turns.warmUp(warmUpMillis, () -> pile.play(new double[pile.frames]));
      Play last = null;
      for (double[] round : nanos) {
        last = pile.play(round);
      }
      add(rows, pile.name, SeriesRows.medians(List.of(nanos)), last);
    }
    return rows;
  }

  private static void add(List<Row> rows, String name, double[] frames, Play play) {
    double seconds = (double) frames.length / FRAMES_A_SECOND;
    double sum = Arrays.stream(frames).sum();
    double worst = Arrays.stream(frames).max().orElseThrow();
    rows.add(row(name, SECOND, "mean", sum / seconds, "ns", frames.length));
    rows.add(row(name, FRAME, "median", SeriesRows.median(frames), "ns", frames.length));
    rows.add(row(name, FRAME, "max", worst, "ns", frames.length));
    rows.add(row(name, IMPACTS, "mean", play.impacts / seconds, "1", frames.length));
    rows.add(row(name, RESTING, "end", play.resting, "1", frames.length));
  }

  private static Row row(
      String scene, String metric, String stat, double value, String unit, int n) {
    return new Row(scene, "carom", "", metric, stat, value, unit, n, 0);
  }
}
