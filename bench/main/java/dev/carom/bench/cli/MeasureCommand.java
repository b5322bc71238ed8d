// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.util.Set;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;

/** Measures one of the series; each is a subcommand with options of its own. */
@Command(
    name = MeasureCommand.NAME,
    description = {
      "Measures a series of scenes: sweep, scale, features, gas, threads or worlds.",
      "The name of a series alone will do: 'gas' is 'measure gas'."
    },
    footer = {"", "Example: carom-bench measure gas --circles 10000 --steady"},
    synopsisSubcommandLabel = "SERIES",
    subcommands = {
      SweepCommand.class,
      ScaleCommand.class,
      FeaturesCommand.class,
      GasCommand.class,
      ThreadsCommand.class,
      WorldsCommand.class
    })
final class MeasureCommand extends BenchCommand {

  static final String NAME = "measure";

  /** The series: their names are commands, too. */
  static final Set<String> SERIES =
      Set.of("sweep", "scale", "features", "gas", "threads", "worlds");

  @Override
  void run() {
    CommandLine line = spec.commandLine();
    throw new ParameterException(line, CaromBench.expected(line, "is missing"));
  }
}
