// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.peers.Contenders;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The first second of a small game, in a fresh virtual machine for each contender: the time from
 * its start to the end of the first frame, and the slowest of the frames after it.
 */
record StartPart(int fork, List<Contender> contenders) implements Part {

  static final String SCENE = "start";
  static final String TIME = "start_time";

  private static final int FRAMES = 100;
  private static final double NANOS_A_MILLI = 1e6;

  @Override
  public String id() {
    return "time/" + SCENE + "/fork-" + fork;
  }

  @Override
  public double seconds() {
    return 0.5 * contenders.size();
  }

  @Override
  public List<Row> run() {
    List<Row> rows = new ArrayList<>();
    for (Contender contender : contenders) {
      Trial trial = new Trial(SCENE, contender, fork);
      try {
        long start = System.currentTimeMillis();
        String[] told = OtherMachine.run(StartPart.class, List.of(contender.id())).split(" ", -1);
        double first = NANOS_A_MILLI * (Long.parseLong(told[0]) - start);
        rows.add(trial.row(TIME, "first", first, Trial.NANOS, 1));
        rows.add(trial.row(TIME, "worst", Double.parseDouble(told[1]), Trial.NANOS, FRAMES));
      } catch (IOException e) {
        rows.add(trial.failure(e));
      }
    }
    return rows;
  }

  /** 30 circles that collide, among twelve lines. */
  static Scene scene() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 800, 600);
    for (int i = 0; i < 12; i++) {
      double x = 100 + 200 * (i % 4);
      double y = 150 + 150 * (i / 4);
      scene.line(x - 40, y, x + 40, y + 30);
    }
    for (int i = 0; i < 30; i++) {
      scene.circle(60 + 75 * (i % 10), 75 + 225 * (i / 10), 10, 3 - i % 7, 4 - i % 9);
    }
    return scene.build();
  }

  /**
   * Plays the game; prints the time of the clock after the first frame, in milliseconds, and the
   * slowest frame after it, in nanoseconds.
   *
   * @param arguments the id of a contender
   */
  public static void main(String[] arguments) {
    try (Method method = Contenders.byId(arguments[0]).start(scene())) {
      method.frame();
      long first = System.currentTimeMillis();
      long worst = 0;
      for (int frame = 1; frame < FRAMES; frame++) {
        long start = System.nanoTime();
        method.frame();
        worst = Math.max(worst, System.nanoTime() - start);
      }
      System.out.println(String.format(Locale.ROOT, "%d %d", first, worst));
    }
  }
}
