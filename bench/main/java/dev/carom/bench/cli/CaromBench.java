// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.duel.Preset;
import dev.carom.bench.duel.Rival;
import dev.carom.bench.examples.Examples;
import dev.carom.bench.fuzz.EndScene;
import java.io.PrintStream;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;
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
      MeasureCommand.class,
      StabilityCommand.class,
      SimulateCommand.class,
      CastCommand.class,
      RungsCommand.class,
      ReferenceCommand.class,
      ViewCommand.class,
      ExampleCommand.class,
      HashCommand.class,
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
      return commandLine.execute(words(args));
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
    tellVersion(all);
    readByWord(all, Examples.class);
    readByWord(all, EndScene.Layout.class);
    readByWord(all, Rival.class);
    readByWord(all, Preset.class);
    return all;
  }

  /** Reads a constant by its text alone, and lists the texts where it is none of them. */
  private static <E extends Enum<E>> void readByWord(CommandLine all, Class<E> type) {
    List<E> values = List.of(type.getEnumConstants());
    all.registerConverter(
        type,
        word ->
            values.stream()
                .filter(each -> each.toString().equals(word))
                .findFirst()
                .orElseThrow(
                    () ->
                        new TypeConversionException("'%s' is none of %s".formatted(word, values))));
  }

  private static boolean isCommand(String word) {
    return commandLine().getSubcommands().containsKey(word) || MeasureCommand.SERIES.contains(word);
  }

  private static void tellVersion(CommandLine line) {
    line.getCommandSpec().versionProvider(new Version());
    line.getSubcommands().values().forEach(CaromBench::tellVersion);
  }

  /** The command line in full: {@code help}, options alone, and series by their names alone. */
  static String[] words(String... args) {
    Deque<String> words = new ArrayDeque<>(List.of(args));
    if (args.length > 0 && args[0].equals("help")) {
      if (args.length > 1 && !isCommand(args[1])) {
        return new String[] {args[1]}; // which is refused
      }
      words.add("--help");
      words.remove();
    }
    String first = words.isEmpty() ? "-" : words.peek();
    if (MeasureCommand.SERIES.contains(first)) {
      words.push(MeasureCommand.NAME);
    } else if (first.startsWith("-") && !OWN_OPTIONS.contains(first)) {
      words.push(DEFAULT_COMMAND);
    }
    return words.toArray(String[]::new);
  }

  private static int explainUsage(ParameterException e) {
    CommandLine commandLine = e.getCommandLine();
    String command = commandLine.getCommandSpec().qualifiedName();
    String message =
        e instanceof UnmatchedArgumentException unmatched
            ? explain(unmatched) + suggestions(unmatched)
            : e.getMessage();
    commandLine.getErr().printf("%s: %s (see %s --help)%n", command, message, command);
    return CommandLine.ExitCode.USAGE;
  }

  private static String explain(UnmatchedArgumentException unmatched) {
    if (unmatched.isUnknownOption()) {
      return unmatched.getMessage();
    }
    String word = unmatched.getUnmatched().get(0);
    CommandLine commandLine = unmatched.getCommandLine();
    return commandLine.getSubcommands().isEmpty()
        ? "'" + word + "' is one word too many"
        : expected(commandLine, "is " + word);
  }

  /** A message about the command that a command line lacks, or has wrong. */
  static String expected(CommandLine commandLine, String found) {
    String label = commandLine.getCommandSpec().usageMessage().synopsisSubcommandLabel();
    return "%s %s: expected one of %s"
        .formatted(label.replaceAll("\\W", ""), found, commandLine.getSubcommands().keySet());
  }

  /** The words that come nearest to one that is unknown. */
  private static String suggestions(UnmatchedArgumentException unmatched) {
    if (unmatched.getSuggestions().isEmpty()) {
      return "";
    }
    Stream<String> nearest = unmatched.getSuggestions().stream().limit(MOST_SUGGESTIONS);
    return "; did you mean " + nearest.collect(Collectors.joining(" or ")) + "?";
  }
}
