// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.ScalePlan.Model;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.TimeUnit;

/**
 * Plays the scenes of a {@link ScalePlan} by several methods in one process, which take turns in
 * random order. The time of a frame is the mean of a round's frames; of the rounds the median, the
 * least and the greatest are told.
 */
public final class Scale {

  /** The metric of the times of a frame. */
  public static final String TIME = "scale_time";

  /** The metric of the impacts of a frame, on average. */
  public static final String IMPACTS = "scale_impacts";

  /** The metric of what a world takes of memory. */
  public static final String MEMORY = "scale_memory";

  /** The stat of a method one frame of which took longer than the limit: that frame's time. */
  public static final String TIMED_OUT = "timed out";

  /** What the scenes' names begin with. */
  public static final String SCENE = "scale:";

  private final ScalePlan plan;
  private final Random random;
  private final List<Row> rows = new ArrayList<>();

  /** Which have played a frame that was too long. */
  private final Set<Contender> timedOut = new HashSet<>();

  /**
   * Prepares it.
   *
   * @param plan what to play
   * @param turns seed of the order in which methods take turns
   */
  public Scale(ScalePlan plan, long turns) {
    this.plan = plan;
    random = new Random(turns);
  }

  /**
   * Measures.
   *
   * @param model what the circles are to each other
   * @param contenders what to play it by
   * @param progress called after each scene
   * @return the rows
   * @throws CannotPlaceException if a scene has no room
   */
  public List<Row> run(Model model, List<Contender> contenders, Runnable progress)
      throws CannotPlaceException {
    rows.clear();
    timedOut.clear();
    warmUp(plan.scene(model, plan.sides().get(0)), contenders);
    for (int side : plan.sides()) {
      play(
          SCENE + model.label() + "=" + ScalePlan.circles(side),
          plan.scene(model, side),
          contenders.stream().filter(c -> !timedOut.contains(c)).toList());
      progress.run();
    }
    return List.copyOf(rows);
  }

  private void warmUp(Scene scene, List<Contender> contenders) {
    for (Contender contender : contenders) {
      long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(plan.warmUpMillis());
      try (Method method = contender.start(scene)) {
        while (System.nanoTime() < end) {
          method.frame();
        }
      }
    }
  }

  private void play(String name, Scene scene, List<Contender> contenders) {
    Map<Contender, Method> playing = new LinkedHashMap<>();
    for (Contender contender : contenders) {
      Method method = contender.start(scene);
      double nanos = first(method);
      if (nanos > TimeUnit.MILLISECONDS.toNanos(plan.limitMillis())) {
        timedOut.add(contender);
        add(name, contender, TIME, TIMED_OUT, nanos, "ns", 1);
        method.close();
      } else {
        playing.put(contender, method);
      }
    }
    Map<Contender, double[]> times = new HashMap<>();
    playing.keySet().forEach(c -> times.put(c, new double[plan.rounds()]));
    Map<Contender, long[]> counts = new HashMap<>();
    playing.keySet().forEach(c -> counts.put(c, new long[2]));
    List<Contender> order = new ArrayList<>(playing.keySet());
    for (int round = -1; round < plan.rounds(); round++) {
      Collections.shuffle(order, random);
      for (Contender contender : order) {
        double nanos = round(playing.get(contender), counts.get(contender));
        if (round >= 0) { // the one before warms up
          times.get(contender)[round] = nanos;
        }
      }
    }
    playing.forEach(
        (contender, method) -> {
          add(name, contender, times.get(contender), counts.get(contender));
          method.close();
        });
  }

  private static double first(Method method) {
    long start = System.nanoTime();
    method.frame();
    return System.nanoTime() - start;
  }

  /** The mean time of a frame; adds frames and impacts to the counts. */
  private double round(Method method, long[] counts) {
    long end = TimeUnit.MILLISECONDS.toNanos(plan.roundMillis());
    long sum = 0;
    int frames = 0;
    while (frames == 0 || sum < end) {
      long start = System.nanoTime();
      method.frame();
      sum += System.nanoTime() - start;
      frames++;
      counts[0]++;
      counts[1] += Math.max(0, method.impacts()) + Math.max(0, method.wallImpacts());
    }
    return (double) sum / frames;
  }

  private void add(String name, Contender contender, double[] times, long[] counts) {
    double[] sorted = times.clone();
    Arrays.sort(sorted);
    int n = sorted.length;
    double median = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
    add(name, contender, TIME, "median", median, "ns", n);
    add(name, contender, TIME, "min", sorted[0], "ns", n);
    add(name, contender, TIME, "max", sorted[n - 1], "ns", n);
    if (counts[1] > 0) { // engines do not tell
      add(name, contender, IMPACTS, "mean", (double) counts[1] / counts[0], "1", counts[0]);
    }
  }

  private void add(
      String name, Contender c, String metric, String stat, double value, String unit, long n) {
    rows.add(new Row(name, c.method(), c.knob(), metric, stat, value, unit, n, 0));
  }
}
