// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.Main;
import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.io.UncheckedIOException;
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
        List<String> command = new ArrayList<>(arguments);
        command.addAll(List.of("--csv", csv.toString()));
        OtherMachine.run(Main.class, command);
        return ResultsCsv.read(csv).stream().map(this::ofThisFork).toList();
      } finally {
        Files.delete(csv);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(id + " failed: " + e.getMessage(), e);
    }
  }

  private Row ofThisFork(Row r) {
    return new Row(
        r.scene(), r.method(), r.knob(), r.metric(), r.stat(), r.value(), r.unit(), r.n(), fork);
  }
}
