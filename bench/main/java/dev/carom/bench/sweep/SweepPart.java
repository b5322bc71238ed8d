// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.sweep;

import dev.carom.bench.Main;
import dev.carom.bench.measures.Part;
import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.Row;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The sweep as a part of the report, in a virtual machine of its own: in one that counts the
 * library's work, its times would be those of counting, too.
 */
public final class SweepPart implements Part {

  private final boolean quick;

  /**
   * Prepares it.
   *
   * @param quick whether a few scenes will do
   */
  public SweepPart(boolean quick) {
    this.quick = quick;
  }

  @Override
  public String id() {
    return "sweep";
  }

  @Override
  public List<Row> run() {
    try {
      Path csv = Files.createTempFile("carom-sweep", ".csv");
      try {
        play(csv);
        return ResultsCsv.read(csv);
      } finally {
        Files.delete(csv);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void play(Path csv) throws IOException {
    Path log = Files.createTempFile("carom-sweep", ".log");
    try {
      Process process =
          new ProcessBuilder(command(csv))
              .redirectErrorStream(true)
              .redirectOutput(log.toFile())
              .start();
      if (process.waitFor() != 0) {
        throw new IOException("the sweep failed: " + Files.readString(log).strip());
      }
      Files.delete(log);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("the sweep was interrupted", e);
    }
  }

  private List<String> command(Path csv) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
    String path = new File(System.getProperty("java.class.path")).getPath();
    command.addAll(List.of("-cp", path, Main.class.getName(), "sweep", "--csv", csv.toString()));
    if (quick) {
      command.add("--quick");
    }
    return command;
  }
}
