// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.UsageMessageSpec;

/** The list of commands in the help, grouped by what they are for. */
enum CommandGroups {
  TRY("Try it:", "replay view example simulate cast"),
  MEASURE("Measure:", "report measure stability rungs jmh"),
  CHECK("Look for mistakes:", "fuzz hash reference");

  private final String heading;
  private final String commands;

  CommandGroups(String heading, String commands) {
    this.heading = heading;
    this.commands = commands;
  }

  /** Has the help of a command line show its commands in these groups. */
  static void show(CommandLine all) {
    all.getHelpSectionMap().put(UsageMessageSpec.SECTION_KEY_COMMAND_LIST_HEADING, help -> "");
    all.getHelpSectionMap()
        .put(
            UsageMessageSpec.SECTION_KEY_COMMAND_LIST,
            help ->
                Arrays.stream(values())
                    .map(group -> group.list(help))
                    .collect(Collectors.joining()));
  }

  private String list(Help help) {
    Map<String, Help> ours = new LinkedHashMap<>();
    for (String name : commands.split(" ", -1)) {
      ours.put(name, help.subcommands().get(name));
    }
    return "%n%s%n".formatted(heading) + help.commandList(ours);
  }
}
