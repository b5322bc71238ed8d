// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.ScalePlan.Model;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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

  /** The prefix of the scenes' names. */
  public static final String SCENE = "scale:";

  private final ScalePlan plan;
  private final Turns turns;

  /** Which have played a frame that was too long. */
  private final Set<Contender> timedOut = new HashSet<>();

  private SeriesRows rows;

  /** The progress of a method in a scene. */
  private static final class Playing {
    private final Method method;
    private long frames;
    private long impacts;

    Playing(Method method) {
      this.method = method;
    }

    /** A round of at least this time, and of at least one frame; the mean time of a frame. */
    double round(long least) {
      long sum = 0;
      int count = 0;
      while (count == 0 || sum < least) {
        sum += frame(method);
        count++;
        impacts += Math.max(0, method.impacts()) + Math.max(0, method.wallImpacts());
      }
      frames += count;
      return (double) sum / count;
    }
  }

  /**
   * Prepares it.
   *
   * @param plan what to play
   * @param turns seed of the order in which methods take turns
   */
  public Scale(ScalePlan plan, long turns) {
    this.plan = plan;
    this.turns = new Turns(turns);
  }

  /**
   * Measures.
   *
   * @param model what the circles are to each other
   * @param contenders what to play it by
   * @param progress called after each scene
   * @throws CannotPlaceException if a scene has no room
   */
  public List<Row> run(Model model, List<Contender> contenders, Runnable progress)
      throws CannotPlaceException {
    rows = new SeriesRows(TIME, IMPACTS);
    timedOut.clear();
    warmUp(plan.scene(model, plan.sides().get(0)), contenders);
    for (int side : plan.sides()) {
      play(
          SCENE + model.label() + "=" + ScalePlan.circles(side),
          plan.scene(model, side),
          contenders.stream().filter(c -> !timedOut.contains(c)).toList());
      progress.run();
    }
    return rows.all();
  }

  private void warmUp(Scene scene, List<Contender> contenders) {
    for (Contender contender : contenders) {
      try (Method method = contender.start(scene)) {
        Turns.warmUp(plan.warmUpMillis(), method::frame);
      }
    }
  }

  private void play(String name, Scene scene, List<Contender> contenders) {
    Map<Contender, Playing> playing = new LinkedHashMap<>();
    for (Contender contender : contenders) {
      start(name, scene, contender).ifPresent(started -> playing.put(contender, started));
    }
    long least = TimeUnit.MILLISECONDS.toNanos(plan.roundMillis());
    turns.round(playing.keySet(), contender -> playing.get(contender).round(least)); // warms up
    turns
        .rounds(plan.rounds(), playing.keySet(), contender -> playing.get(contender).round(least))
        .forEach((contender, nanos) -> end(name, contender, playing.get(contender), nanos));
  }

  /** Nothing if the first frame took too long. */
  private Optional<Playing> start(String name, Scene scene, Contender contender) {
    Method method = contender.start(scene);
    long nanos = frame(method);
    if (nanos <= TimeUnit.MILLISECONDS.toNanos(plan.limitMillis())) {
      return Optional.of(new Playing(method));
    }
    timedOut.add(contender);
    rows.addTime(name, contender, TIMED_OUT, (double) nanos, 1);
    method.close();
    return Optional.empty();
  }

  private static long frame(Method method) {
    long start = System.nanoTime();
    method.frame();
    return System.nanoTime() - start;
  }

  private void end(String name, Contender contender, Playing its, List<Double> times) {
    double[] nanos = times.stream().mapToDouble(Double::doubleValue).toArray();
    rows.addTimes(name, contender, "median", SeriesRows.median(nanos), nanos);
    if (its.impacts > 0) { // engines do not tell
      rows.addImpacts(name, contender, its.impacts, its.frames);
    }
    its.method.close();
  }
}
