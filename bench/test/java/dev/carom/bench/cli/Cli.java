// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.stream.Stream;
import picocli.CommandLine;

/** One call of the command line, without a process of its own. */
record Cli(int exitCode, String out, String err) {

  /** Calls a command: the words of the first argument, then each of the others. */
  static Cli run(String command, Object... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine commandLine = CaromBench.commandLine();
    commandLine.setOut(new PrintWriter(out));
    commandLine.setErr(new PrintWriter(err));
    Stream<Object> words = Stream.concat(Stream.of(command.split(" ", -1)), Stream.of(args));
    int exitCode =
        CaromBench.execute(commandLine, words.map(Object::toString).toArray(String[]::new));
    return new Cli(exitCode, out.toString(), err.toString());
  }
}
