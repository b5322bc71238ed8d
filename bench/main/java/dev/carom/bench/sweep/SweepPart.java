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
 * One round of the sweep as a part of the report, in a virtual machine of its own: in one that
 * counts the library's work, its times would be those of counting, too.
 */
public final class SweepPart implements Part {

  private static final int REPLAYS = 5;
  private static final int QUICK_REPLAYS = 2;
  private static final int QUICK_WARM_UP_MILLIS = 1000;

  private final int fork;
  private final boolean quick;

  /**
   * Prepares it.
   *
   * @param fork the number of the virtual machine, from 0
   * @param quick whether a few scenes will do
   */
  public SweepPart(int fork, boolean quick) {
    this.fork = fork;
    this.quick = quick;
  }

  @Override
  public String id() {
    return "sweep/fork-" + fork;
  }

  @Override
  public double seconds() {
    return quick ? 5 : 25;
  }

  @Override
  public List<Row> run() {
    try {
      Path csv = Files.createTempFile("carom-sweep", ".csv");
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
    command.addAll(List.of("--replays", Integer.toString(quick ? QUICK_REPLAYS : REPLAYS)));
    command.addAll(List.of("--turns", Integer.toString(fork)));
    if (quick) {
      command.addAll(List.of("--quick", "--warm-up", Integer.toString(QUICK_WARM_UP_MILLIS)));
    }
    return command;
  }
}
