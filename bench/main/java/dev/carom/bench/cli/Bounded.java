// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Checks of numbers from the command line; what fails them is a usage error. */
final class Bounded {

  private Bounded() {}

  static void atLeast(long least, String option, long value, CommandSpec spec) {
    if (value < least) {
      throw refused(option, Long.toString(value), "at least " + least, spec);
    }
  }

  static void atMost(long most, String option, long value, CommandSpec spec) {
    if (value > most) {
      throw refused(option, Long.toString(value), "at most " + most, spec);
    }
  }

  static void positive(String option, double value, CommandSpec spec) {
    if (!(value > 0 && value <= Double.MAX_VALUE)) {
      throw refused(option, Decimals.shortest(value), "a finite number, more than 0", spec);
    }
  }

  /** A usage error for a number of a scene that cannot be made, by the name of its option. */
  static ParameterException refused(IllegalArgumentException e, CommandSpec spec) {
    String message = e.getMessage();
    String option = "--" + message.split(" ", 2)[0];
    boolean isNamed = spec.commandLine().getCommandSpec().findOption(option) != null;
    return new ParameterException(spec.commandLine(), isNamed ? "--" + message : message, e);
  }

  private static ParameterException refused(
      String option, String value, String expected, CommandSpec spec) {
    return new ParameterException(
        spec.commandLine(), option + " is " + value + ": expected " + expected);
  }
}
