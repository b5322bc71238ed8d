// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVPrinter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/**
 * A CSV file that appears as a whole or not at all: rows go to a draft beside it, which {@link
 * #commit} puts in its place and {@link #close} without it throws away.
 */
final class OutputFile implements AutoCloseable {

  private static final CSVFormat FORMAT =
      CSVFormat.DEFAULT.builder().setRecordSeparator('\n').get();

  private final Path target;
  private final Path draft;
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
    return file.toAbsolutePath().normalize().equals(other.toAbsolutePath().normalize())
        || (Files.exists(file) && Files.exists(other) && Files.isSameFile(file, other));
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
    Path folder = target.toAbsolutePath().getParent();
    prepareFolder(folder);
    if (!Files.isWritable(isSpecial(target) ? target : folder)) {
      throw new IOException(target + ": cannot be written");
    }
  }

  private static void expectFile(Path target) throws IOException {
    if (Files.isDirectory(target)) {
      throw new IOException(target + ": is a folder: expected a file");
    }
  }

  private OutputFile(Path target, String... header) throws IOException {
    this.target = target;
    draft = isSpecial(target) ? target : target.resolveSibling(target.getFileName() + ".draft");
    printer = new CSVPrinter(openDraft(), FORMAT);
    printer.printRecord((Object[]) header);
  }

  /** Whether it is a pipe or a device: written to as it is, where other files have a draft. */
  private static boolean isSpecial(Path target) {
    return Files.exists(target) && !Files.isRegularFile(target);
  }

  private Writer openDraft() throws IOException {
    try {
      return Files.newBufferedWriter(draft);
    } catch (IOException e) {
      throw new IOException(target + ": cannot be written", e);
    }
  }

  void row(Object... fields) throws IOException {
    printer.printRecord(fields);
  }

  void commit() throws IOException {
    printer.close();
    if (!draft.equals(target)) {
      Files.move(draft, target, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  @Override
  public void close() throws IOException {
    printer.close();
    if (!draft.equals(target)) {
      Files.deleteIfExists(draft);
    }
  }
}
