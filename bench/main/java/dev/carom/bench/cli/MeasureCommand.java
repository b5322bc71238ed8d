// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.util.Set;
import picocli.CommandLine.Command;

/** Measures one of the series; each is a subcommand with options of its own. */
@Command(
    name = MeasureCommand.NAME,
    description = {
      "Measures a series of scenes: sweep, scale, features, gas or threads.",
      "The name of a series alone will do: 'gas' is 'measure gas'."
    },
    footer = {"", "Example: carom-bench measure gas --circles 10000 --steady"},
    mixinStandardHelpOptions = true,
    synopsisSubcommandLabel = "SERIES",
    subcommands = {
      SweepCommand.class,
      ScaleCommand.class,
      FeaturesCommand.class,
      GasCommand.class,
      ThreadsCommand.class
    })
final class MeasureCommand {

  static final String NAME = "measure";

  /** The series: their names are commands, too. */
  static final Set<String> SERIES = Set.of("sweep", "scale", "features", "gas", "threads");
}
