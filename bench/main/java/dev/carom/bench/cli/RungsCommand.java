// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.measures.RungShare;
import dev.carom.bench.measures.RungSurvey;
import dev.carom.bench.measures.RungTable;
import dev.carom.bench.measures.SceneRungs;
import dev.carom.bench.results.Row;
import dev.carom.bench.series.Features;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Tells how often the detector needed more precision. */
@Command(
    name = "rungs",
    description = {
      "Counts how often double-double and exact numbers were needed.",
      "By family of queries: how many plain doubles decide, how many double-double or sums"
          + " without rounding, how many exact numbers. Also: whether double-double or exact"
          + " numbers round the time of an impact after time 0. Takes seconds.",
      "With --scenes also by scene of the command features, some of them with gravity."
    },
    footer = {"", "Example: carom-bench rungs --queries 1000 --scenes"})
final class RungsCommand extends BenchCommand {

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
      description = "Another seed, other queries and scenes (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Option(names = "--scenes", description = "Play the scenes of features, too.")
  private boolean playsScenes;

  @Mixin private RowFiles files;

  @Override
  void run() throws IOException, CannotPlaceException {
    Bounded.atLeast(1, "--queries", queries, spec);
    files.prepare();
    List<RungShare> shares = survey();
    List<SceneRungs> scenes = playsScenes ? scenes() : List.of();
    Stream<Row> rows =
        Stream.concat(
            shares.stream().flatMap(s -> s.rows().stream()),
            scenes.stream().flatMap(s -> s.rows().stream()));
    files.write(Map.of("rungs", seed), false, rows.toList());
    print(RungTable.render(shares) + (playsScenes ? "\n" + SceneRungs.render(scenes) : ""));
  }

  private List<SceneRungs> scenes() throws CannotPlaceException {
    Features features = new Features(seed, seed);
    try (Progress progress = Progress.start("scenes", features.size())) {
      return features.rungs(progress::step);
    }
  }

  private List<RungShare> survey() {
    try (Progress progress = Progress.start("rungs", RungSurvey.families())) {
      return RungSurvey.of(queries, seed, progress::step);
    }
  }
}
