// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.NoSuchFileException;
import org.openjdk.jmh.runner.RunnerException;
import picocli.CommandLine;

/** Tells a person in one line why a run failed. */
final class Failure {

  private Failure() {}

  /** Prints one line for what can go wrong with files, numbers and runs; hands on the rest. */
  static int explain(Exception e, CommandLine commandLine) throws Exception {
    Exception cause = e instanceof UncheckedIOException wrapped ? wrapped.getCause() : e;
    if (!isExpected(cause)) {
      throw e;
    }
    String command = commandLine.getCommandSpec().qualifiedName();
    commandLine.getErr().println(command + ": " + reason(cause));
    return CommandLine.ExitCode.SOFTWARE;
  }

  private static boolean isExpected(Exception e) {
    return e instanceof IOException
        || e instanceof CannotPlaceException
        || e instanceof RunnerException
        || e instanceof IllegalArgumentException
        || e instanceof IllegalStateException;
  }

  /** Those of java.nio.file carry nothing but the path. */
  private static String reason(Exception e) {
    if (e instanceof NoSuchFileException) {
      return e.getMessage() + ": no such file";
    }
    if (e instanceof FileAlreadyExistsException) {
      return e.getMessage() + ": is a file: expected a folder";
    }
    if (e instanceof AccessDeniedException) {
      return e.getMessage() + ": access denied";
    }
    return e.getMessage();
  }
}
