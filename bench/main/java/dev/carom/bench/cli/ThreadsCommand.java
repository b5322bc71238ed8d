// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.examples.SplitWorld;
import dev.carom.bench.replay.Counted;
import java.io.PrintWriter;
import java.util.Arrays;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Times a scene on one thread beside the same scene split over several. */
@Command(
    name = "threads",
    description = {
      "Times a scene on one thread, and split over several.",
      "Its circles must ignore each other. The two take turns. Each thread has a"
          + " world of its own, and all meet after each frame."
    },
    footer = {"", "Example: carom-bench threads --circles 100000 --crosses 50000 --frames 30"},
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class ThreadsCommand implements Callable<Integer> {

  @Spec private CommandSpec spec;

  @Mixin private SceneOptions scenes;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "2",
      description = "How many (default: ${DEFAULT-VALUE}).")
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
  public Integer call() throws Exception {
    Bounded.atLeast(1, "--threads", threads, spec);
    Bounded.atLeast(1, "--frames", frames, spec);
    Bounded.atLeast(1, "--rounds", rounds, spec);
    Scene scene = scenes.scene();
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
      print(alone, together, ratios);
    }
    return 0;
  }

  /** Microseconds per frame. */
  private double time(World world) {
    long begin = System.nanoTime();
    for (int i = 0; i < frames; i++) {
      world.step(1);
    }
    return (System.nanoTime() - begin) / 1e3 / frames;
  }

  private double time(SplitWorld world) throws InterruptedException, ExecutionException {
    long begin = System.nanoTime();
    double now = world.parts().get(0).now();
    for (int i = 1; i <= frames; i++) {
      while (!world.advanceTo(now + i)) {} // unfinished: go on
    }
    return (System.nanoTime() - begin) / 1e3 / frames;
  }

  private static double median(double... sorted) {
    return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
  }

  private void print(double[] alone, double[] together, double[] ratios) {
    Arrays.sort(alone);
    Arrays.sort(together);
    Arrays.sort(ratios);
    PrintWriter out = spec.commandLine().getOut();
    out.printf(Locale.ROOT, "scene     %s%n", scenes.name());
    out.printf(
        "run       %s of %s each, in turns%n",
        Counted.of(rounds, "round"), Counted.of(frames, "frame"));
    print("1 thread", "us per frame", alone);
    print(Counted.of(threads, "thread"), "us per frame", together);
    print("ratio", "of a round on one thread to the next one, split", ratios);
    out.printf(
        Locale.ROOT, "fastest   %.2f, of the fastest round of each%n", alone[0] / together[0]);
    out.flush();
  }

  private void print(String name, String what, double... sorted) {
    spec.commandLine()
        .getOut()
        .printf(
            Locale.ROOT,
            "%-10s%,.2f %s, the median (%,.2f .. %,.2f)%n",
            name,
            median(sorted),
            what,
            sorted[0],
            sorted[sorted.length - 1]);
  }
}
