// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.methods.LineContender;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** One round of query times: each way to answer in a fresh virtual machine, in random order. */
record QueryTimePart(int fork, List<String> ids, int warmUpMillis) implements Part {

  @Override
  public String id() {
    return "query-time/fork-" + fork;
  }

  @Override
  public double seconds() {
    return ids.size() * (0.7 + warmUpMillis / 1000.0);
  }

  @Override
  public List<Row> run() {
    List<LineContender> order = new ArrayList<>(ids.stream().map(LineContender::byId).toList());
    Collections.shuffle(order, new Random(fork));
    List<Row> rows = new ArrayList<>();
    for (LineContender contender : order) {
      rows.addAll(rowsOf(contender));
    }
    return rows;
  }

  List<Row> rowsOf(LineContender contender) {
    try {
      return start(contender)
          .lines()
          .filter(line -> line.matches(QueryClock.LINE))
          .map(line -> line.split(" "))
          .map(
              words ->
                  QueryPart.trial(words[0], contender, fork)
                      .row(
                          "query_time",
                          "median",
                          Double.parseDouble(words[1]),
                          Trial.NANOS,
                          QueryClock.QUERIES))
          .toList();
    } catch (IOException e) {
      return List.of(QueryPart.trial("all", contender, fork).failure(e));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return List.of(QueryPart.trial("all", contender, fork).failure("interrupted"));
    }
  }

  private String start(LineContender contender) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
    command.addAll(List.of("-cp", System.getProperty("java.class.path")));
    command.addAll(
        List.of(QueryClock.class.getName(), contender.id(), Integer.toString(warmUpMillis)));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    try (InputStream out = process.getInputStream()) {
      String text = new String(out.readAllBytes(), StandardCharsets.UTF_8);
      int exit = process.waitFor();
      if (exit != 0) {
        String reason = text.lines().findFirst().orElse("exit code " + exit);
        throw new IOException("the clock of " + contender.id() + " failed: " + reason);
      }
      return text;
    } finally {
      process.destroy();
    }
  }
}
