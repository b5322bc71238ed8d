// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.Method;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.SweepPlan.Point;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;

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

  /** What the scenes' names begin with. */
  public static final String SCENE = "sweep:";

  /** The name of the axis on which frames stand by their impacts. */
  public static final String BY_IMPACTS = "impacts";

  /** A class of frames with fewer than these is not told: its greatest is luck. */
  private static final int LEAST_FRAMES = 5;

  private final SweepPlan plan;
  private final Map<String, Function<Scene, Method>> methods;
  private final SplittableRandom random;
  private final List<Row> rows = new ArrayList<>();
  private final Map<String, Map<Integer, List<Double>>> byImpacts = new LinkedHashMap<>();

  /**
   * Prepares a sweep.
   *
   * @param plan what to play
   * @param methods what to play it by, by label
   * @param seed of the order in which methods take turns
   */
  public Sweep(SweepPlan plan, Map<String, Function<Scene, Method>> methods, long seed) {
    this.plan = plan;
    this.methods = new LinkedHashMap<>(methods);
    random = new SplittableRandom(seed);
  }

  /**
   * Measures.
   *
   * @param warmUpMillis how long all methods play before the first scene
   * @param progress called after each scene
   * @return the rows
   * @throws CannotPlaceException if a scene has no room
   */
  public List<Row> run(int warmUpMillis, Runnable progress) throws CannotPlaceException {
    warmUp(warmUpMillis);
    for (Point point : plan.points()) {
      measure(point);
      progress.run();
    }
    byImpacts.forEach(
        (method, classes) ->
            classes.forEach((impacts, times) -> addFrames(method, impacts, times)));
    return rows;
  }

  private void warmUp(int millis) throws CannotPlaceException {
    Point last = plan.points().get(plan.points().size() - 1);
    Scene scene = last.crosses().scene();
    long deadline = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
    while (System.nanoTime() < deadline) {
      for (String method : methods.keySet()) {
        times(method, scene);
      }
    }
  }

  private void measure(Point point) throws CannotPlaceException {
    Scene scene = point.crosses().scene();
    Map<String, double[][]> times = new LinkedHashMap<>();
    methods.keySet().forEach(method -> times.put(method, new double[plan.replays()][]));
    for (int replay = 0; replay < plan.replays(); replay++) {
      for (String method : shuffled()) {
        times.get(method)[replay] = times(method, scene);
      }
    }
    String name = SCENE + point.axis().label() + "=" + point.at();
    boolean sorted = point.axis() == SweepPlan.Axis.RADIUS;
    times.forEach((method, replays) -> add(name, method, scene, medians(replays), sorted));
  }

  private List<String> shuffled() {
    List<String> order = new ArrayList<>(methods.keySet());
    for (int i = order.size() - 1; i > 0; i--) {
      order.add(i, order.remove(random.nextInt(i + 1)));
    }
    return order;
  }

  private double[] times(String method, Scene scene) {
    Method playing = methods.get(method).apply(scene);
    double[] nanos = new double[plan.frames()];
    for (int frame = 0; frame < nanos.length; frame++) {
      long start = System.nanoTime();
      playing.frame();
      nanos[frame] = System.nanoTime() - start;
    }
    return nanos;
  }

  /** Of each frame over all replays: what the machine does besides falls on few of them. */
  private double[] medians(double[][] replays) {
    double[] medians = new double[plan.frames()];
    double[] one = new double[replays.length];
    for (int frame = 0; frame < medians.length; frame++) {
      for (int i = 0; i < replays.length; i++) {
        one[i] = replays[i][frame];
      }
      Arrays.sort(one);
      medians[frame] = (one[(one.length - 1) / 2] + one[one.length / 2]) / 2;
    }
    return medians;
  }

  /** Frames are sorted by their impacts where all scenes have the same number of things. */
  private void add(String name, String method, Scene scene, double[] nanos, boolean sorted) {
    Method playing = methods.get(method).apply(scene);
    long sum = 0;
    for (double time : nanos) {
      playing.frame();
      int impacts = playing.impacts() + playing.wallImpacts();
      sum += impacts;
      if (sorted) {
        byImpacts
            .computeIfAbsent(method, none -> new TreeMap<>())
            .computeIfAbsent(impacts, none -> new ArrayList<>())
            .add(time);
      }
    }
    addTimes(name, method, nanos);
    double mean = (double) sum / nanos.length;
    rows.add(new Row(name, method, "", IMPACTS, "mean", mean, "1", nanos.length, 0));
  }

  private void addFrames(String method, int impacts, List<Double> times) {
    if (times.size() >= LEAST_FRAMES) {
      String name = SCENE + BY_IMPACTS + "=" + impacts;
      addTimes(name, method, times.stream().mapToDouble(t -> t).toArray());
    }
  }

  private void addTimes(String name, String method, double[] nanos) {
    double mean = Arrays.stream(nanos).average().orElse(Double.NaN);
    double least = Arrays.stream(nanos).min().orElse(Double.NaN);
    double most = Arrays.stream(nanos).max().orElse(Double.NaN);
    rows.add(new Row(name, method, "", TIME, "mean", mean, "ns", nanos.length, 0));
    rows.add(new Row(name, method, "", TIME, "min", least, "ns", nanos.length, 0));
    rows.add(new Row(name, method, "", TIME, "max", most, "ns", nanos.length, 0));
  }
}
