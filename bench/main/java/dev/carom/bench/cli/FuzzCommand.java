// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.fuzz.FindingException;
import dev.carom.bench.fuzz.QueryFuzz;
import dev.carom.bench.fuzz.WorldFuzz;
import dev.carom.bench.replay.Counted;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Looks for what must not be, in random worlds and queries. */
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
      "With --queries it asks the detector with numbers of all patterns instead.",
      "The first finding ends the run, with the seed and the scene that show it again."
    },
    footer = {"", "Example: carom-bench fuzz --seconds 600 --seed 7"},
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class FuzzCommand implements Callable<Integer> {

  private static final List<String> LENGTHS = List.of("--seconds", "--sessions", "--queries");

  /** Queries between two looks at the progress. */
  private static final int PARTS = 20;

  @Spec private CommandSpec spec;

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

  @Option(names = "--queries", paramLabel = "N", description = "Ask so many queries instead.")
  private Long queries;

  @Option(
      names = "--seed",
      paramLabel = "S",
      defaultValue = "1",
      description = "Of the first world, or of all queries (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Override
  public Integer call() {
    List<String> lengths = LENGTHS.stream().filter(this::isGiven).toList();
    if (lengths.size() > 1) {
      String both = String.join(" and ", lengths.subList(0, 2));
      throw new ParameterException(spec.commandLine(), both + " exclude each other");
    }
    Bounded.atLeast(1, "--seconds", seconds, spec);
    if (sessions != null) {
      Bounded.atLeast(1, "--sessions", sessions, spec);
    }
    if (queries != null) {
      Bounded.atLeast(1, "--queries", queries, spec);
    }
    try {
      print(queries != null ? ask() : play());
    } catch (FindingException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
    return 0;
  }

  private boolean isGiven(String option) {
    return spec.commandLine().getParseResult().hasMatchedOption(option);
  }

  private void print(String line) {
    PrintWriter out = spec.commandLine().getOut();
    out.println(line);
    out.flush();
  }

  private String ask() throws FindingException {
    QueryFuzz fuzz = new QueryFuzz(seed);
    try (Progress progress = Progress.start("fuzz", PARTS)) {
      for (int part = 1; part <= PARTS; part++) {
        fuzz.ask(queries * part / PARTS - fuzz.queries());
        progress.step();
      }
    }
    return String.format(
        Locale.ROOT,
        "no finding in %s: %s, %,d refused as they must be",
        Counted.of(fuzz.queries(), "query", "queries"),
        Counted.of(fuzz.hits(), "hit"),
        fuzz.refused());
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
}
