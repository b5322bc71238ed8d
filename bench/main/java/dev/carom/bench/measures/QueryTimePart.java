// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.methods.LineContender;
import dev.carom.bench.results.Row;
import java.io.IOException;
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
      List<String> arguments = List.of(contender.id(), Integer.toString(warmUpMillis));
      return OtherMachine.run(QueryClock.class, arguments)
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
      return List.of(
          QueryPart.trial("all", contender, fork)
              .failure(e.getMessage().lines().findFirst().orElseThrow()));
    }
  }
}
