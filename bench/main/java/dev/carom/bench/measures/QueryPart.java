// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.LineContender;
import dev.carom.bench.methods.LineDetector;
import dev.carom.bench.results.Row;
import dev.carom.oracle.Contact;
import dev.carom.oracle.SegmentQuery;
import java.util.ArrayList;
import java.util.List;

/**
 * Right and wrong answers to one class of questions, judged by the exact oracle: misses, false
 * hits, and the error of the times where both see an impact after time 0, in ulps of the true time.
 * A time that is not a number is wrong either way.
 */
record QueryPart(String name, int count) implements Part {

  @Override
  public String id() {
    return "query/" + name;
  }

  @Override
  public double seconds() {
    return count / 4000.0;
  }

  @Override
  public List<Row> run() {
    List<SegmentQuery> queries = Queries.draw(name, count);
    List<Contact> truths = queries.stream().map(SegmentQuery::truth).toList();
    List<Row> rows = new ArrayList<>();
    for (LineContender contender : LineContender.all()) {
      rows.addAll(
          judge(trial(name, contender, Trial.ANY_FORK), contender.detector(), queries, truths));
    }
    return rows;
  }

  static Trial trial(String name, LineContender line, int fork) {
    Contender contender = new Contender(line.id(), line.method(), line.knob(), null);
    return new Trial("query:" + name, contender, fork);
  }

  static List<Row> judge(
      Trial trial, LineDetector detector, List<SegmentQuery> queries, List<Contact> truths) {
    AnswerErrors errors = new AnswerErrors();
    for (int i = 0; i < queries.size(); i++) {
      SegmentQuery q = queries.get(i);
      double time =
          detector.time(
              q.px(), q.py(), q.r(), q.vx(), q.vy(), q.ax(), q.ay(), q.bx(), q.by(), q.end());
      errors.add(truths.get(i), time);
    }
    return errors.rows(trial);
  }
}
