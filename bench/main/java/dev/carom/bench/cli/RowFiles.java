// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.report.Origin;
import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.ResultsJson;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The files that each command which measures can write: one row a number, in one form for all. */
final class RowFiles {

  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  @Option(
      names = "--csv",
      paramLabel = "FILE",
      description = "Write the numbers as CSV, one a line.")
  private Path csv;

  @Option(
      names = "--json",
      paramLabel = "FILE",
      description = "Write the numbers as JSON, with the machine and the commit.")
  private Path json;

  /** Makes the folders, and refuses one file for both, before anything long begins. */
  void prepare() throws IOException {
    OutputFile.expectOther("--json", json, "--csv", csv, spec);
    if (csv != null) {
      OutputFile.prepare(csv);
    }
    if (json != null) {
      OutputFile.prepare(json);
    }
  }

  /** Refuses to write to a file that another option names. */
  void expectOther(String option, Path other) throws IOException {
    OutputFile.expectOther("--csv", csv, option, other, spec);
    OutputFile.expectOther("--json", json, option, other, spec);
  }

  /** Writes the rows, and returns them with where they come from. */
  Results write(Map<String, Long> seeds, boolean quick, List<Row> rows) throws IOException {
    Metadata origin = Origin.of(seeds, "", quick);
    Results results = new Results(origin, rows);
    if (csv != null) {
      ResultsCsv.write(rows, csv);
    }
    if (json != null) {
      ResultsJson.write(results, json);
    }
    return results;
  }
}
