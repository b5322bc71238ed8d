// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.experiment.Gas;
import dev.carom.bench.fuzz.EndScene;
import dev.carom.bench.fuzz.FindingException;
import dev.carom.bench.fuzz.Soak;
import dev.carom.bench.fuzz.SoakTimes;
import dev.carom.bench.fuzz.WorldFuzz;
import dev.carom.bench.replay.Counted;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.IntConsumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Looks for what must not be, in random worlds. */
@Command(
    name = "fuzz",
    description = {
      "Plays random worlds with random edits, and checks every flight exactly.",
      "Worlds have neighbours by ulps, ties, lattices, crowds and extremes; in some, lines and pegs"
          + " move, or circles fall. In each fourth world impacts would not end without a rule:"
          + " trapped circles, pockets, infinite masses, doors, heaps, bumpers, falls.",
      "Checked after every step, by exact arithmetic of its own: flights are"
          + " continuous and pass through no line, peg, wall or circle; nothing hangs in the air;"
          + " energy is as the responses allow; the log is in the order of time; rows and states"
          + " are the same if the step is cut, restored on the way, or of one circle alone.",
      "With --impacts it runs one world for very many impacts, with each step checked as above: the"
          + " canonical scene, a gas, or a scene on which the end rule works. It tells the heap in"
          + " use, and the time per impact at the start and at the end.",
      "The first finding ends the run, with the seed and the scene that show it again."
    },
    footer = {
      "",
      "Example: carom-bench fuzz --seconds 600 --seed 7",
      "         carom-bench fuzz --impacts 1000000 --gas"
    })
final class FuzzCommand extends BenchCommand {

  private static final List<String> LENGTHS = List.of("--seconds", "--sessions", "--impacts");

  /** Options of a run of very many impacts. */
  private static final List<String> SCENES = List.of("--scene", "--gas", "--circles");

  private static final double PACKING = 0.2;

  @Option(
      names = "--seconds",
      paramLabel = "N",
      defaultValue = "60",
      description = "How long to play worlds (default: ${DEFAULT-VALUE}).")
  private int seconds;

  @Option(
      names = "--sessions",
      paramLabel = "N",
      description = "Play so many worlds instead, each with its own seed from --seed on.")
  private Integer sessions;

  @Option(
      names = "--impacts",
      paramLabel = "N",
      description = "Run one world instead for so many impacts, at least 100,000.")
  private Long impacts;

  @Option(
      names = "--gas",
      description =
          "With --impacts: a gas of circles that collide, instead of the canonical scene.")
  private boolean gas;

  @Option(
      names = "--scene",
      paramLabel = "KIND",
      description = {
        "With --impacts: a scene on which the end rule works, instead of the canonical one: trapped"
            + " circles, pockets of some ulps, infinite masses, doors that crush balls, a heap that"
            + " each step pushes downwards, or bumpers; or balls under gravity: a fall among slopes"
            + " and pegs, a pile, or plinko (${COMPLETION-CANDIDATES})."
      })
  private EndScene.Layout kind;

  @Option(
      names = "--circles",
      paramLabel = "N",
      description = "With --impacts: how many circles (default: 100; of the gas 1,000).")
  private Integer circles;

  @Option(
      names = "--seed",
      paramLabel = "S",
      defaultValue = "1",
      description = "Of the first world, or of the one scene (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Override
  void run() throws CannotPlaceException {
    excludeOthers(LENGTHS);
    Bounded.atLeast(1, "--seconds", seconds, spec);
    if (sessions != null) {
      Bounded.atLeast(1, "--sessions", sessions, spec);
    }
    if (impacts == null) {
      for (String option : SCENES) {
        if (isGiven(option)) {
          throw refused(option + " needs --impacts");
        }
      }
    } else {
      Bounded.atLeast(100_000, "--impacts", impacts, spec);
      if (kind != null) {
        excludeOthers(SCENES);
      }
    }
    try {
      if (impacts != null) {
        soak();
      } else {
        println(play());
      }
    } catch (FindingException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  /** Refuses two of these options at once. */
  private void excludeOthers(List<String> options) {
    List<String> given = options.stream().filter(this::isGiven).toList();
    if (given.size() > 1) {
      String both = String.join(" and ", given.subList(0, 2));
      throw refused(both + " exclude each other");
    }
  }

  private String play() throws FindingException {
    WorldFuzz fuzz = new WorldFuzz();
    long start = System.nanoTime();
    long end = start + TimeUnit.SECONDS.toNanos(seconds);
    long shown = 0;
    try (Progress progress = Progress.start("fuzz", sessions != null ? sessions : seconds)) {
      while (sessions != null ? fuzz.sessions() < sessions : System.nanoTime() < end) {
        fuzz.play(seed + fuzz.sessions());
        long done =
            sessions != null
                ? fuzz.sessions()
                : TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - start);
        for (; shown < done; shown++) {
          progress.step();
        }
      }
    }
    return String.format(
        Locale.ROOT,
        "no finding in %s: %s, %s, %s (%s jammed)",
        Counted.of(fuzz.sessions(), "world"),
        Counted.of(fuzz.steps(), "step"),
        Counted.of(fuzz.impacts(), "impact"),
        Counted.of(fuzz.flights(), "flight"),
        Counted.of(fuzz.jams(), "circle"));
  }

  private void soak() throws FindingException, CannotPlaceException {
    Scene scene = kind == null ? scene() : null;
    println(
        kind == null
            ? "soak       %s--circles %d --seed %d"
                .formatted(gas ? "--gas " : "", scene.count(Kind.CIRCLE), seed)
            : "soak       --scene " + kind + " --seed " + seed);
    try (Progress progress = Progress.start("fuzz", Soak.ROUNDS)) {
      RoundsLeft left = new RoundsLeft(progress, spec.commandLine().getErr());
      IntConsumer told = round -> left.tell(round, Soak.ROUNDS);
      SoakTimes times =
          kind == null ? Soak.run(scene, impacts, told) : Soak.run(kind, seed, impacts, told);
      println(times.render().stripTrailing());
    }
  }

  private Scene scene() throws CannotPlaceException {
    try {
      return gas
          ? new Gas(circles == null ? 1_000 : circles, PACKING, 1, false, seed).scene()
          : new Crosses(circles == null ? 100 : circles, 50, 10, 1, 10, seed).scene();
    } catch (IllegalArgumentException e) {
      throw Bounded.refused(e, spec);
    }
  }
}
