// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** The command line as a whole: its commands, what runs without one, and how errors are told. */
@Command(
    name = "carom-bench",
    description = {
      "Measures Carom: speed and accuracy of circles that move and bounce.",
      "Without a command it replays the published experiment."
    },
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    synopsisSubcommandLabel = "[COMMAND]",
    footer = {
      "",
      "COMMAND --help, or help COMMAND, explains a command, its options, and how long it takes on"
          + " two cores.",
      "Exit code: 0 done, 1 a failed run or bad data, 2 a wrong command line.",
      "",
      "Example: carom-bench replay --circles 50"
    },
    subcommands = {
      ReplayCommand.class,
      ReportCommand.class,
      SweepCommand.class,
      StabilityCommand.class,
      ScaleCommand.class,
      FeaturesCommand.class,
      GasCommand.class,
      SimulateCommand.class,
      CastCommand.class,
      RungsCommand.class,
      ReferenceCommand.class,
      ViewCommand.class,
      ExampleCommand.class,
      ThreadsCommand.class,
      HashCommand.class,
      SoakCommand.class,
      FuzzCommand.class,
      JmhCommand.class
    })
public final class CaromBench {

  private static final String DEFAULT_COMMAND = "replay";
  private static final Set<String> OWN_OPTIONS = Set.of("-h", "--help", "-V", "--version");

  private static final int MOST_SUGGESTIONS = 2;

  /** Made by {@link #commandLine}. */
  CaromBench() {}

  /**
   * Runs one command. Options without a command are those of {@code replay}.
   *
   * @return the exit code: 0 done, 1 failed, 2 a wrong command line
   */
  public static int execute(String... args) {
    return exitCode(execute(commandLine(), args), System.out, System.err);
  }

  /** The exit code of a run; 1 if the standard output, which throws nothing, lost some of it. */
  static int exitCode(int exitCode, PrintStream out, PrintStream err) {
    if (!out.checkError() || exitCode != CommandLine.ExitCode.OK) {
      return exitCode;
    }
    err.println("carom-bench: standard output: cannot be written");
    return CommandLine.ExitCode.SOFTWARE;
  }

  static int execute(CommandLine commandLine, String... args) {
    try {
      return commandLine.execute(isHelp(commandLine, args) ? help(args) : withCommand(args));
    } catch (OutOfMemoryError e) {
      commandLine
          .getErr()
          .println("carom-bench: not enough memory: give the virtual machine more by -Xmx");
      return CommandLine.ExitCode.SOFTWARE;
    }
  }

  static CommandLine commandLine() {
    CommandLine all =
        new CommandLine(new CaromBench())
            .setParameterExceptionHandler((e, args) -> explainUsage(e))
            .setExecutionExceptionHandler((e, line, parsed) -> Failure.explain(e, line));
    CommandGroups.show(all);
    all.getSubcommands().values().forEach(c -> c.getCommandSpec().versionProvider(new Version()));
    return all;
  }

  /** Whether this is {@code help}, or {@code help COMMAND}. */
  private static boolean isHelp(CommandLine commandLine, String... args) {
    return args.length > 0
        && args[0].equals("help")
        && (args.length == 1 || commandLine.getSubcommands().containsKey(args[1]));
  }

  private static String[] help(String... args) {
    String[] words = Arrays.copyOfRange(args, 1, args.length + 1);
    words[args.length - 1] = "--help";
    return words;
  }

  private static String[] withCommand(String... args) {
    boolean named = args.length > 0 && (!args[0].startsWith("-") || OWN_OPTIONS.contains(args[0]));
    if (named) {
      return args;
    }
    String[] more = new String[args.length + 1];
    more[0] = DEFAULT_COMMAND;
    System.arraycopy(args, 0, more, 1, args.length);
    return more;
  }

  private static int explainUsage(ParameterException e) {
    CommandLine commandLine = e.getCommandLine();
    String command = commandLine.getCommandSpec().qualifiedName();
    String message = e.getMessage() + suggestions(e);
    commandLine.getErr().printf("%s: %s (see %s --help)%n", command, message, command);
    return CommandLine.ExitCode.USAGE;
  }

  /** The words that come nearest to one that is unknown. */
  private static String suggestions(ParameterException e) {
    if (!(e instanceof UnmatchedArgumentException unmatched)
        || unmatched.getSuggestions().isEmpty()) {
      return "";
    }
    Stream<String> nearest = unmatched.getSuggestions().stream().limit(MOST_SUGGESTIONS);
    return "; did you mean " + nearest.collect(Collectors.joining(" or ")) + "?";
  }
}
