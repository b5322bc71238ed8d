// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.Main;
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
 * A command of this program as a part of the report, in a virtual machine of its own: in one that
 * counts the library's work, its times would be those of counting, too.
 *
 * @param id the name of the part
 * @param seconds how long it takes, roughly
 * @param fork the number of the virtual machine, from 0
 * @param arguments the command and its options, without {@code --csv}
 */
public record CommandPart(String id, double seconds, int fork, List<String> arguments)
    implements Part {

  /** Keeps the arguments as they are. */
  public CommandPart {
    arguments = List.copyOf(arguments);
  }

  @Override
  public List<Row> run() {
    try {
      Path csv = Files.createTempFile("carom-part", ".csv");
      try {
        play(csv);
        return ResultsCsv.read(csv).stream().map(this::ofThisFork).toList();
      } finally {
        Files.delete(csv);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Row ofThisFork(Row r) {
    return new Row(
        r.scene(), r.method(), r.knob(), r.metric(), r.stat(), r.value(), r.unit(), r.n(), fork);
  }

  private void play(Path csv) throws IOException {
    Path log = Files.createTempFile("carom-part", ".log");
    try {
      Process process =
          new ProcessBuilder(command(csv))
              .redirectErrorStream(true)
              .redirectOutput(log.toFile())
              .start();
      if (process.waitFor() != 0) {
        throw new IOException(id + " failed: " + Files.readString(log).strip());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException(id + " was interrupted", e);
    } finally {
      Files.delete(log);
    }
  }

  private List<String> command(Path csv) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
    String path = new File(System.getProperty("java.class.path")).getPath();
    command.addAll(List.of("-cp", path, Main.class.getName()));
    command.addAll(arguments);
    command.addAll(List.of("--csv", csv.toString()));
    return command;
  }
}
