// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Gas;
import dev.carom.bench.gas.GasOverlap;
import dev.carom.bench.gas.GasReplay;
import dev.carom.bench.gas.GasSteady;
import dev.carom.bench.replay.Counted;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Plays a gas of circles that collide, and tells how fast and how well energy is kept. */
@Command(
    name = "gas",
    description = {
      "Makes and times a gas of circles that collide.",
      "Tells collisions per second, time per frame, and how well energy is kept."
          + " The published algorithm knows no collisions between circles, so there is"
          + " nothing beside it. Takes seconds."
    },
    footer = {"", "Example: carom-bench measure gas --circles 10000 --steady"})
final class GasCommand extends BenchCommand {

  @Option(
      names = "--circles",
      paramLabel = "N",
      defaultValue = "1000",
      description = "How many circles (default: ${DEFAULT-VALUE}).")
  private int circles;

  @Option(
      names = "--packing",
      paramLabel = "ETA",
      defaultValue = "0.2",
      description = "The part of the bounds that they cover (default: ${DEFAULT-VALUE}).")
  private double packing;

  @Option(
      names = "--spread",
      paramLabel = "R",
      defaultValue = "1",
      description = "Radii are uniform from 1 to R (default: ${DEFAULT-VALUE}).")
  private double spread;

  @Option(names = "--heavy", description = "Masses are radii squared; without it, all are 1.")
  private boolean heavy;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Which of the random scenes (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Option(
      names = "--frames",
      paramLabel = "N",
      defaultValue = "600",
      description = "Frames of one replay (default: ${DEFAULT-VALUE}).")
  private int frames;

  @Option(
      names = "--frame-time",
      paramLabel = "T",
      defaultValue = "1",
      description =
          "How long a frame of a replay lasts (default: ${DEFAULT-VALUE}); in a unit of time a"
              + " circle of mass 1 moves by 1.25 on average.")
  private double frameTime;

  @Option(
      names = {"--rounds", "--replays"},
      paramLabel = "N",
      defaultValue = "5",
      description =
          "Replays, of which the fastest counts; those before warm up (default: ${DEFAULT-VALUE}).")
  private int rounds;

  @Mixin private RowFiles files;

  @Option(
      names = "--steady",
      paramLabel = "N",
      arity = "0..1",
      fallbackValue = "1000000",
      description =
          "Time the steady state instead: one world, as many rounds as --rounds, each of at least"
              + " N collisions (default: ${FALLBACK-VALUE}), after a warm-up of 5 for each"
              + " circle and at least 3,000,000; tells the median, least and most of the rounds.")
  private Integer steady;

  @Option(
      names = "--save",
      paramLabel = "FILE",
      description = "Write the scene, for simulate and for others.")
  private Path save;

  @Override
  void run() throws IOException, CannotPlaceException {
    Bounded.atLeast(1, "--frames", frames, spec);
    Bounded.positive("--frame-time", frameTime, spec);
    Bounded.atLeast(1, "--rounds", rounds, spec);
    if (steady != null) {
      Bounded.atLeast(1, "--steady", steady, spec);
    }
    Scene scene = scene();
    files.expectOther("--save", save);
    files.prepare();
    if (save != null) {
      scene.write(save);
    }
    String found = steady == null ? replay(scene) : steady(scene);
    print("gas      %s%n%s".formatted(name(), found));
  }

  private Scene scene() throws CannotPlaceException {
    try {
      return new Gas(circles, packing, spread, heavy, seed).scene();
    } catch (IllegalArgumentException e) {
      throw Bounded.refused(e, spec);
    }
  }

  private String name() {
    return "--seed %d --circles %d --packing %s --spread %s%s"
        .formatted(
            seed,
            circles,
            Decimals.plain(packing),
            Decimals.plain(spread),
            heavy ? " --heavy" : "");
  }

  private String steady(Scene scene) throws IOException {
    GasSteady found = GasSteady.play(scene, rounds, steady);
    write(
        row("gas_collision", "median", found.median(), "ns", found.collisions()),
        row("gas_collision", "min", found.least(), "ns", found.collisions()),
        row("gas_collision", "max", found.most(), "ns", found.collisions()),
        row("gas_allocated", "last round", (double) found.bytes(), "bytes", 1));
    return String.format(
        Locale.ROOT,
        """
        run      %s of the steady state, %s in %s
        speed    %,.0f collisions per second, %,.1f ns per collision (%,.1f .. %,.1f)
        bytes    %,d allocated in the last round
        """,
        Counted.of(found.frames(), "frame"),
        Counted.of(found.collisions(), "collision"),
        Counted.of(rounds, "round"),
        1e9 / found.median(),
        found.median(),
        found.least(),
        found.most(),
        found.bytes());
  }

  private String replay(Scene scene) throws IOException {
    GasReplay best = GasReplay.play(scene, frames, frameTime);
    for (int i = 1; i < rounds; i++) {
      GasReplay next = GasReplay.play(scene, frames, frameTime);
      best = next.nanos() < best.nanos() ? next : best;
    }
    double overlap = GasOverlap.deepest(scene, frames, frameTime);
    double perFrame = (double) best.nanos() / frames;
    write(
        row("gas_time", "min", perFrame, "ns", frames),
        row("gas_collisions", "sum", (double) best.collisions(), "1", frames),
        row("gas_wall_impacts", "sum", (double) best.wallImpacts(), "1", frames),
        row("gas_energy", "end", best.energyChange(), "1", frames),
        row("gas_overlap", "max", overlap, "radii", frames));
    return String.format(
        Locale.ROOT,
        """
        run      %s of %s, the fastest of %s
        impacts  %,d between circles, %,d with walls
        speed    %,.0f collisions per second, %,.1f us per frame
        energy   changed by %.1e of itself
        overlap  %.1e of a radius at most, at the ends of frames
        """,
        Counted.of(frames, "frame"),
        Decimals.plain(frameTime),
        Counted.of(rounds, "replay"),
        best.collisions(),
        best.wallImpacts(),
        best.collisions() * 1e9 / best.nanos(),
        perFrame / 1e3,
        best.energyChange(),
        overlap);
  }

  private Row row(String metric, String stat, double value, String unit, long n) {
    return new Row("gas: " + name(), "carom", "", metric, stat, value, unit, n, 0);
  }

  private void write(Row... rows) throws IOException {
    files.write(Map.of("gas", seed), false, List.of(rows));
  }
}
