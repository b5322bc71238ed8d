// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.measures.RungShare;
import dev.carom.bench.measures.RungSurvey;
import dev.carom.bench.measures.RungTable;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Tells how often the detector needed more precision. */
@Command(
    name = "rungs",
    description = {
      "Counts how often double-double and exact numbers were needed.",
      "By family of queries: how many plain doubles decide, how many double-double or sums"
          + " without rounding, how many exact numbers. Also: whether double-double or exact"
          + " numbers round the time of an impact after time 0. Takes seconds."
    },
    footer = {"", "Example: carom-bench rungs --queries 1000"},
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class RungsCommand implements Callable<Integer> {

  @Spec private CommandSpec spec;

  @Option(
      names = "--queries",
      paramLabel = "N",
      defaultValue = "10000",
      description = "Queries of each family (default: ${DEFAULT-VALUE}).")
  private int queries;

  @Option(
      names = "--seed",
      paramLabel = "S",
      defaultValue = "1",
      description = "Another seed, other queries (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Mixin private RowFiles files;

  @Override
  public Integer call() throws IOException {
    Bounded.atLeast(1, "--queries", queries, spec);
    files.prepare();
    List<RungShare> shares = survey();
    files.write(
        Map.of("rungs", seed), false, shares.stream().flatMap(s -> s.rows().stream()).toList());
    spec.commandLine().getOut().print(RungTable.render(shares));
    spec.commandLine().getOut().flush();
    return 0;
  }

  private List<RungShare> survey() {
    try (Progress progress = Progress.start("rungs", RungSurvey.families())) {
      return RungSurvey.of(queries, seed, progress::step);
    }
  }
}
