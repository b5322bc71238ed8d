// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.report.SeriesTables;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.ManyWorlds;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Times many small worlds on one thread and on several. */
@Command(
    name = "worlds",
    description = {
      "Times many small worlds on one thread and on several.",
      "Each is a ball that falls among pegs, with a seed of its own. Worlds share nothing; the hash"
          + " of all must not depend on the threads. Takes seconds."
    },
    footer = {"", "Example: carom-bench measure worlds --worlds 100000 --threads 8"})
final class WorldsCommand extends BenchCommand {

  @Mixin private RowFiles files;

  @Option(
      names = "--worlds",
      paramLabel = "N",
      defaultValue = "10000",
      description = "Worlds of a round (default: ${DEFAULT-VALUE}).")
  private int worlds;

  @Option(
      names = "--threads",
      paramLabel = "N",
      description =
          "The most threads; 1, 2, 4 and so on are measured up to it (default: the cores).")
  private Integer threads;

  @Option(
      names = "--rounds",
      paramLabel = "N",
      defaultValue = "5",
      description = "Rounds on each number of threads, in turns (default: ${DEFAULT-VALUE}).")
  private int rounds;

  @Override
  void run() throws Exception {
    Bounded.atLeast(1, "--worlds", worlds, spec);
    Bounded.atLeast(1, "--rounds", rounds, spec);
    int most = threads == null ? Runtime.getRuntime().availableProcessors() : threads;
    Bounded.atLeast(1, "--threads", most, spec);
    files.prepare();
    int[] counts =
        IntStream.concat(IntStream.iterate(1, n -> n < most, n -> 2 * n), IntStream.of(most))
            .toArray();
    List<Row> rows = new ManyWorlds(worlds, rounds).measure(counts);
    Results results = files.write(Map.of(), false, rows);
    print(SeriesTables.worlds(results).text());
    print(
        String.format(
            Locale.ROOT,
            "memory  %,.0f bytes a world, with its scene%nhash    %08x, the lower half, the same on"
                + " any number of threads%n",
            value(rows, ManyWorlds.MEMORY),
            (long) value(rows, ManyWorlds.HASH)));
  }

  private static double value(List<Row> rows, String metric) {
    return rows.stream().filter(row -> row.metric().equals(metric)).findAny().orElseThrow().value();
  }
}
