// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Unmatched;

/** Hands everything to JMH. */
@Command(
    name = "jmh",
    description = {
      "Runs the microbenchmarks, by the command line of JMH.",
      "They time single queries, what exactness costs, frames, building and reading"
          + " worlds of one circle to a million, gases and their events, and edits. All"
          + " take hours: name one, and a size."
    },
    customSynopsis = "carom-bench jmh [JMH OPTIONS] [REGEXP]...",
    footer = {
      "",
      "JMH explains its options with: jmh -h",
      "It lists the benchmarks with: jmh -l",
      "",
      "Example: carom-bench jmh -prof gc -p circles=1000 GasBenchmark"
    })
final class JmhCommand implements Callable<Integer> {

  @Option(names = "--help", usageHelp = true, description = "Show this help.")
  @SuppressWarnings("unused") // only picocli looks at it
  private boolean help;

  @Unmatched private final List<String> rest = new ArrayList<>();

  @Override
  public Integer call() throws IOException {
    org.openjdk.jmh.Main.main(rest.toArray(String[]::new));
    return 0;
  }
}
