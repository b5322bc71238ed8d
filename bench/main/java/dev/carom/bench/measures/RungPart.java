// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.bench.methods.LineContender;
import dev.carom.bench.methods.LineDetector;
import dev.carom.bench.methods.Method;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.methods.RungCounts;
import dev.carom.bench.results.Row;
import dev.carom.oracle.SegmentQuery;
import java.util.ArrayList;
import java.util.List;

/**
 * Which precision decided: of the questions of each class, and of the pairs that the frames of a
 * scene look at.
 *
 * @param scenes the scenes to play
 */
record RungPart(List<String> scenes, int count) implements Part {

  /** The metric: its stats are {@code asked} and the three rungs; each is a count. */
  static final String METRIC = "rungs";

  private static final LineDetector CAROM = LineContender.byId("carom").detector();

  @Override
  public String id() {
    return "rungs/all";
  }

  @Override
  public double seconds() {
    return scenes.size() + count / 4000.0;
  }

  @Override
  public List<Row> run() {
    List<Row> rows = new ArrayList<>();
    for (String name : Queries.classes()) {
      rows.addAll(ofQuestions("query:" + name, Queries.draw(name, count)));
    }
    for (String name : scenes) {
      rows.addAll(ofFrames(name, Subjects.scene(name), Subjects.FRAMES));
    }
    return rows;
  }

  /** A question counts for the highest rung that one of its decisions needed. */
  static List<Row> ofQuestions(String scene, List<SegmentQuery> queries) {
    long doubleDouble = 0;
    long exact = 0;
    for (SegmentQuery q : queries) {
      RungCounts before = RungCounts.now();
      CAROM.time(q.px(), q.py(), q.r(), q.vx(), q.vy(), q.ax(), q.ay(), q.bx(), q.by(), q.end());
      RungCounts used = RungCounts.now().since(before);
      exact += used.exactDecisions() > 0 ? 1 : 0;
      doubleDouble += used.exactDecisions() == 0 && used.doubtfulDecisions() > 0 ? 1 : 0;
    }
    return rows(scene, queries.size(), doubleDouble, exact);
  }

  static List<Row> ofFrames(String name, Scene scene, int frames) {
    RungCounts before = RungCounts.now();
    try (Method method = Methods.CAROM.start(scene)) {
      for (int frame = 0; frame < frames; frame++) {
        method.frame();
      }
    }
    RungCounts used = RungCounts.now().since(before);
    long doubleDouble = used.doubtfulDecisions() - used.exactDecisions();
    return rows(name, used.pairTests(), doubleDouble, used.exactDecisions());
  }

  private static List<Row> rows(String scene, long asked, long doubleDouble, long exact) {
    Trial trial = new Trial(scene, Methods.CAROM);
    return List.of(
        trial.row(METRIC, "asked", (double) asked, Trial.ONE, asked),
        trial.row(METRIC, "double", (double) (asked - doubleDouble - exact), Trial.ONE, asked),
        trial.row(METRIC, "double-double", (double) doubleDouble, Trial.ONE, asked),
        trial.row(METRIC, "exact", (double) exact, Trial.ONE, asked));
  }
}
