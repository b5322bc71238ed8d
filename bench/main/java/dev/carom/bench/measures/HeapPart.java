// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.List;

/**
 * How one contender lets circles fall into a heap: how deep they reach into each other and into the
 * walls, how much energy comes from nowhere, and when all have come to rest.
 */
record HeapPart(String scene, Contender contender) implements Part {

  static final String OVERLAP = "heap_overlap";
  static final String ENERGY = "heap_energy";
  static final String REST = "heap_rest";

  /** Slower than this, in px a frame, nobody sees a circle move. */
  private static final double AT_REST = 0.01;

  @Override
  public String id() {
    return String.join("/", "heap", scene, contender.id());
  }

  @Override
  public double seconds() {
    return 2;
  }

  @Override
  public List<Row> run() {
    Trial trial = new Trial(scene, contender);
    return trial.rows(() -> measure(trial, Subjects.scene(scene), Subjects.FRAMES));
  }

  /** Of heaps that are not at rest at the end, the frame is infinite. */
  static List<Row> measure(Trial trial, Scene scene, int frames) {
    RecordedRun run = RecordedRun.play(trial.contender(), scene, frames);
    List<Row> rows = new ArrayList<>();
    run.failure().ifPresent(reason -> rows.add(trial.failure(reason)));
    double overlap = 0;
    double gained = 0;
    int moved = 0;
    for (int frame = 1; frame <= frames; frame++) {
      overlap = GasPart.worse(overlap, overlap(run, scene, frame));
      gained += GasPart.worse(0, energy(run, scene, frame) - energy(run, scene, frame - 1));
      for (int i = 0; i < run.circles(); i++) {
        moved = run.speed(frame, i) < AT_REST ? moved : frame;
      }
    }
    double rest = moved == frames ? Double.POSITIVE_INFINITY : moved;
    rows.add(trial.row(OVERLAP, "max", overlap, Trial.RADII, frames));
    rows.add(trial.row(OVERLAP, "end", overlap(run, scene, frames), Trial.RADII, frames));
    rows.add(trial.row(ENERGY, "gained", gained / energy(run, scene, 0), Trial.ONE, frames));
    rows.add(trial.row(REST, "frame", rest, Trial.FRAMES, frames));
    return rows;
  }

  private static double energy(RecordedRun run, Scene scene, int frame) {
    double energy = 0;
    for (int i = 0; i < run.circles(); i++) {
      double speed = run.speed(frame, i);
      energy += speed * speed / 2 - scene.gravity().y() * run.y(frame, i);
    }
    return energy;
  }

  private static double overlap(RecordedRun run, Scene scene, int frame) {
    Bounds b = scene.bounds().orElseThrow();
    double deepest = GasPart.overlap(run, scene, frame);
    for (int i = 0; i < run.circles(); i++) {
      double r = ((Circle) scene.shape(Kind.CIRCLE, i)).radius();
      double x = run.x(frame, i);
      double left = Math.min(x - b.xmin(), b.xmax() - x);
      double room = Math.min(left, run.y(frame, i) - b.ymin());
      deepest = GasPart.worse(deepest, (r - room) / r);
    }
    return deepest;
  }
}
