// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** What all commands have: their help, their output, and usage errors. */
@Command(mixinStandardHelpOptions = true, sortOptions = false)
abstract class BenchCommand implements Callable<Integer> {

  @Spec CommandSpec spec;

  @Override
  public final Integer call() throws Exception {
    run();
    return 0;
  }

  /** Does it; what it throws is told, and the exit code is not 0. */
  abstract void run() throws Exception;

  /** Prints a text at once. */
  final void print(String text) {
    spec.commandLine().getOut().print(text);
    spec.commandLine().getOut().flush();
  }

  /** Prints a line at once. */
  final void println(String line) {
    spec.commandLine().getOut().println(line);
    spec.commandLine().getOut().flush();
  }

  final boolean isGiven(String option) {
    return spec.commandLine().getParseResult().hasMatchedOption(option);
  }

  /** A usage error. */
  final ParameterException refused(String message) {
    return new ParameterException(spec.commandLine(), message);
  }
}
