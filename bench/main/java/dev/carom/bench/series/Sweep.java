// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.SweepPlan.Point;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Plays the scenes of a {@link SweepPlan} by several methods in one process, which take turns in
 * random order. The time of a frame is its median over replays; of these times a scene's mean,
 * least and greatest are told, as the published figures do.
 */
public final class Sweep {

  /** The metric of the times. */
  public static final String TIME = "sweep_time";

  /** The metric of the impacts of a frame, with lines and walls, on average. */
  public static final String IMPACTS = "sweep_impacts";

  /** The prefix of the scenes' names. */
  public static final String SCENE = "sweep:";

  /** The name of the axis on which frames stand by their impacts. */
  public static final String BY_IMPACTS = "impacts";

  /** A class of frames with fewer than these is not told: its greatest is luck. */
  private static final int LEAST_FRAMES = 5;

  private final SweepPlan plan;
  private final List<Contender> contenders;
  private final Turns turns;
  private final SeriesRows rows = new SeriesRows(TIME, IMPACTS);
  private final Map<Contender, Map<Integer, List<Double>>> byImpacts = new LinkedHashMap<>();

  /**
   * Prepares a sweep.
   *
   * @param plan what to play
   * @param contenders what to play it by
   * @param turns seed of the order in which methods take turns
   */
  public Sweep(SweepPlan plan, List<Contender> contenders, long turns) {
    this.plan = plan;
    this.contenders = List.copyOf(contenders);
    this.turns = new Turns(turns);
  }

  /**
   * Measures.
   *
   * @param warmUpMillis how long all methods play before the first scene
   * @param progress called after each scene
   * @throws CannotPlaceException if a scene has no room
   */
  public List<Row> run(int warmUpMillis, Runnable progress) throws CannotPlaceException {
    warmUp(warmUpMillis);
    for (Point point : plan.points()) {
      measure(point);
      progress.run();
    }
    byImpacts.forEach(
        (contender, classes) ->
            classes.forEach((impacts, times) -> addFrames(contender, impacts, times)));
    return rows.all();
  }

  private void warmUp(int millis) throws CannotPlaceException {
    Point last = plan.points().get(plan.points().size() - 1);
    Scene scene = last.crosses().scene();
    Turns.warmUp(millis, () -> contenders.forEach(contender -> replay(contender, scene)));
  }

  private void measure(Point point) throws CannotPlaceException {
    Scene scene = point.crosses().scene();
    Map<Contender, List<double[]>> nanos =
        turns.rounds(plan.replays(), contenders, contender -> replay(contender, scene));
    String name = SCENE + point.axis().label() + "=" + point.at();
    boolean sorted = point.axis() == SweepPlan.Axis.RADIUS;
    nanos.forEach(
        (contender, replays) -> add(name, contender, scene, SeriesRows.medians(replays), sorted));
  }

  /** The time of each frame. */
  private double[] replay(Contender contender, Scene scene) {
    double[] nanos = new double[plan.frames()];
    try (Method method = contender.start(scene)) {
      for (int frame = 0; frame < nanos.length; frame++) {
        long start = System.nanoTime();
        method.frame();
        nanos[frame] = System.nanoTime() - start;
      }
    }
    return nanos;
  }

  /** Frames are sorted by their impacts where all scenes have the same number of things. */
  private void add(String name, Contender contender, Scene scene, double[] nanos, boolean sorted) {
    long sum = 0;
    try (Method method = contender.start(scene)) {
      for (double time : nanos) {
        method.frame();
        int impacts = method.impacts() + method.wallImpacts();
        sum += impacts;
        if (sorted) {
          byImpacts
              .computeIfAbsent(contender, none -> new TreeMap<>())
              .computeIfAbsent(impacts, none -> new ArrayList<>())
              .add(time);
        }
      }
    }
    addTimes(name, contender, nanos);
    rows.addImpacts(name, contender, sum, nanos.length);
  }

  private void addFrames(Contender contender, int impacts, List<Double> times) {
    if (times.size() >= LEAST_FRAMES) {
      String name = SCENE + BY_IMPACTS + "=" + impacts;
      addTimes(name, contender, times.stream().mapToDouble(t -> t).toArray());
    }
  }

  private void addTimes(String name, Contender contender, double[] nanos) {
    double mean = Arrays.stream(nanos).average().orElse(Double.NaN);
    rows.addTimes(name, contender, "mean", mean, nanos);
  }
}
