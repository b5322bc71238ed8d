// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.replay.ReplayPlan;
import dev.carom.bench.replay.ReplayRun;
import dev.carom.bench.replay.Samples;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import org.openjdk.jmh.runner.RunnerException;

/**
 * One round of frame times: each contender in a fresh virtual machine, in random order. The raw
 * times, of two scenes and the first round only, are those of the replay whose slowest frame is the
 * median one.
 */
record TimePart(String scene, int fork, List<Contender> contenders, int replays, int warmUpMillis)
    implements Part {

  /** Where single frames are shown: they are most of all rows. */
  private static final Set<String> RAW = Set.of("base-1", "fast-1");

  /** A method that looks at more pairs in a frame plays only the first frames. */
  private static final long MUCH_WORK = 500_000;

  private static final int FEW_FRAMES = 60;

  @Override
  public String id() {
    return "time/" + scene + "/fork-" + fork;
  }

  /** Starting a virtual machine takes about a second, and the slowest play as long as they warm. */
  @Override
  public double seconds() {
    return contenders.size() * (0.9 + warmUpMillis / 1000.0 + 0.15 * replays);
  }

  @Override
  public List<Row> run() {
    List<Row> rows = new ArrayList<>();
    for (Contender contender : ReplayRun.shuffled(contenders, fork)) {
      rows.addAll(measure(contender));
    }
    return rows;
  }

  private List<Row> measure(Contender contender) {
    Trial trial = new Trial(scene, contender, fork);
    try {
      ReplayPlan plan = plan(contender, Subjects.scene(scene));
      try (ReplayRun run = ReplayRun.open(plan)) {
        return rows(trial, run.fork(contender, fork), plan.frames());
      }
    } catch (UnsupportedOperationException | RunnerException | IOException e) {
      return List.of(
          trial.row("frame_time", "median", Double.NaN, Trial.NANOS, 0), trial.failure(e));
    }
  }

  private ReplayPlan plan(Contender contender, Scene measured) {
    List<Scene> others = Subjects.others(scene);
    int frames = framesFor(contender, measured);
    return new ReplayPlan(
        scene, measured, others, List.of(contender), frames, replays, 1, warmUpMillis);
  }

  private static int framesFor(Contender contender, Scene measured) {
    try (Method method = contender.start(measured)) {
      method.frame();
      return method.pairTests() > MUCH_WORK ? FEW_FRAMES : Subjects.FRAMES;
    }
  }

  private List<Row> rows(Trial trial, Samples samples, int frames) {
    List<double[]> byWorst =
        samples.replays().stream()
            .map(nanos -> Arrays.stream(nanos).asDoubleStream().toArray())
            .sorted(Comparator.comparingDouble(times -> new Quantiles(times).max()))
            .toList();
    double[] typical = byWorst.get((byWorst.size() - 1) / 2);
    Quantiles all = new Quantiles(byWorst.stream().flatMapToDouble(Arrays::stream).toArray());
    List<Row> rows = new ArrayList<>();
    rows.add(time(trial, "mean", all.mean(), all));
    rows.add(time(trial, "p5", all.at(0.05), all));
    rows.add(time(trial, "median", all.median(), all));
    rows.add(time(trial, "p95", all.at(0.95), all));
    rows.add(time(trial, "p99", all.at(0.99), all));
    rows.add(time(trial, "worst", new Quantiles(typical).max(), all));
    double bytes = (double) samples.bytesAllocated() / frames;
    rows.add(trial.row("allocated", "mean", bytes, "bytes", frames));
    boolean raw = fork == 0 && RAW.contains(scene);
    for (int frame = 1; raw && frame <= typical.length; frame++) {
      rows.add(trial.row("frame_raw", "frame@" + frame, typical[frame - 1], Trial.NANOS, 1));
    }
    return rows;
  }

  private static Row time(Trial trial, String stat, double nanos, Quantiles all) {
    return trial.row("frame_time", stat, nanos, Trial.NANOS, all.size());
  }
}
