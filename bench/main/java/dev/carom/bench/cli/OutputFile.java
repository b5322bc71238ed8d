// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.results.WholeFile;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVPrinter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/**
 * A CSV file that appears as a whole, with {@link #commit}, or not at all: see {@link WholeFile}.
 */
final class OutputFile implements AutoCloseable {

  private static final CSVFormat FORMAT =
      CSVFormat.DEFAULT.builder().setRecordSeparator('\n').get();

  private final WholeFile file;
  private final CSVPrinter printer;

  /** Opens a file that is to have this header, or nothing if there is no path. */
  static OutputFile open(Path target, String... header) throws IOException {
    if (target == null) {
      return null;
    }
    expectFile(target);
    return new OutputFile(target, header);
  }

  /**
   * Refuses a file to be written that is another one of the command line, too; either may be null.
   */
  static void expectOther(
      String option, Path file, String otherOption, Path other, CommandSpec spec)
      throws IOException {
    if (file != null && other != null && isOne(file, other)) {
      throw new ParameterException(
          spec.commandLine(),
          option + " is " + file + ": expected another file than " + otherOption);
    }
  }

  private static boolean isOne(Path file, Path other) throws IOException {
    return absolute(file).equals(absolute(other))
        || (Files.exists(file) && Files.exists(other) && Files.isSameFile(file, other));
  }

  private static Path absolute(Path file) throws IOException {
    return WholeFile.target(file).toAbsolutePath().normalize();
  }

  /** Makes a folder if need be. */
  static void prepareFolder(Path folder) throws IOException {
    try {
      Files.createDirectories(folder);
    } catch (NoSuchFileException e) {
      throw new IOException(folder + ": cannot be made", e);
    }
  }

  /** Makes the folder of a file, and refuses what cannot be one: before long work, not after it. */
  static void prepare(Path target) throws IOException {
    expectFile(target);
    Path folder = WholeFile.target(target).toAbsolutePath().getParent();
    prepareFolder(folder);
    if (!Files.isWritable(WholeFile.isSpecial(target) ? target : folder)) {
      throw new IOException(target + ": cannot be written: access denied");
    }
  }

  private static void expectFile(Path target) throws IOException {
    if (Files.isDirectory(target)) {
      throw new IOException(target + ": is a folder: expected a file");
    }
  }

  private OutputFile(Path target, String... header) throws IOException {
    file = WholeFile.create(target);
    Writer out = new OutputStreamWriter(file.out(), StandardCharsets.UTF_8);
    printer = new CSVPrinter(new BufferedWriter(out), FORMAT);
    printer.printRecord((Object[]) header);
  }

  void row(Object... fields) throws IOException {
    printer.printRecord(fields);
  }

  void commit() throws IOException {
    printer.close();
    file.commit();
  }

  /** Without {@link #commit}, rows that are still to be written are not. */
  @Override
  public void close() throws IOException {
    file.close();
  }
}
