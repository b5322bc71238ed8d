// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.examples.SplitWorld;
import dev.carom.bench.replay.Counted;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Times a scene on one thread beside the same scene split over several. */
@Command(
    name = "threads",
    description = {
      "Times a scene on one thread, and split over several.",
      "Its circles must ignore each other. The two take turns. Each thread has a"
          + " world of its own, and all meet after each frame. Takes a second, and longer for"
          + " larger scenes."
    },
    footer = {
      "",
      "Example: carom-bench measure threads --circles 99999 --crosses 120 --radius 1 --frames 30"
    })
final class ThreadsCommand extends BenchCommand {

  @Mixin private SceneOptions scenes;

  @Mixin private RowFiles files;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "2",
      description = "How many threads share the scene (default: ${DEFAULT-VALUE}).")
  private int threads;

  @Option(
      names = "--frames",
      paramLabel = "N",
      defaultValue = "100",
      description = "Frames of a round, each one unit of time (default: ${DEFAULT-VALUE}).")
  private int frames;

  @Option(
      names = "--rounds",
      paramLabel = "N",
      defaultValue = "15",
      description = "Rounds of each, after a third as many to warm up (default: ${DEFAULT-VALUE}).")
  private int rounds;

  @Override
  void run() throws Exception {
    Bounded.atLeast(1, "--threads", threads, spec);
    Bounded.atLeast(1, "--frames", frames, spec);
    Bounded.atLeast(1, "--rounds", rounds, spec);
    files.expectOther("--scene", scenes.file());
    Scene scene = scenes.scene();
    files.prepare();
    World one = new World(scene);
    try (SplitWorld split = new SplitWorld(scene, threads)) {
      double[] alone = new double[rounds];
      double[] together = new double[rounds];
      double[] ratios = new double[rounds];
      for (int i = -(rounds + 2) / 3; i < rounds; i++) {
        double a = time(one);
        double b = time(split);
        if (i >= 0) {
          alone[i] = a;
          together[i] = b;
          ratios[i] = a / b;
        }
      }
      tell(alone, together, ratios);
    }
  }

  /** Nanoseconds per frame. */
  private double time(World world) {
    long begin = System.nanoTime();
    for (int i = 0; i < frames; i++) {
      world.step(1);
    }
    return (double) (System.nanoTime() - begin) / frames;
  }

  private double time(SplitWorld world) throws InterruptedException, ExecutionException {
    long begin = System.nanoTime();
    double now = world.parts().get(0).now();
    for (int i = 1; i <= frames; i++) {
      world.advanceTo(now + i);
    }
    return (double) (System.nanoTime() - begin) / frames;
  }

  private static double median(double... sorted) {
    return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
  }

  private void tell(double[] alone, double[] together, double[] ratios) throws IOException {
    Arrays.sort(alone);
    Arrays.sort(together);
    Arrays.sort(ratios);
    files.write(
        Map.of(),
        false,
        Stream.of(
                rows("frame_time", "threads=1", "ns", alone),
                rows("frame_time", "threads=" + threads, "ns", together),
                rows("threads_ratio", "threads=" + threads, "1", ratios))
            .flatMap(List::stream)
            .toList());
    print(
        String.format(
            Locale.ROOT,
            "scene         %s%nrun           %s of %s each, in turns%n%s%s%s"
                + "fastest       %.2f, of the fastest round of each%n",
            scenes.name(),
            Counted.of(rounds, "round"),
            Counted.of(frames, "frame"),
            line(Counted.of(1, "thread"), 1e3, "us per frame", alone),
            line(Counted.of(threads, "thread"), 1e3, "us per frame", together),
            line("ratio", 1, "of a round on one thread to the next one, split", ratios),
            alone[0] / together[0]));
  }

  private List<Row> rows(String metric, String knob, String unit, double... sorted) {
    return List.of(
        row(metric, knob, "median", median(sorted), unit),
        row(metric, knob, "min", sorted[0], unit),
        row(metric, knob, "max", sorted[sorted.length - 1], unit));
  }

  private Row row(String metric, String knob, String stat, double value, String unit) {
    return new Row(scenes.name(), "carom", knob, metric, stat, value, unit, rounds, 0);
  }

  private static String line(String name, double unit, String what, double... sorted) {
    return String.format(
        Locale.ROOT,
        "%-14s%,.2f %s, the median (%,.2f .. %,.2f)%n",
        name,
        median(sorted) / unit,
        what,
        sorted[0] / unit,
        sorted[sorted.length - 1] / unit);
  }
}
