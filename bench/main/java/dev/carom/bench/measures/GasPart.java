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
 * How true one contender stays to a gas of elastic circles that collide: its energy, how deep
 * circles reach into each other, and how many are lost.
 */
record GasPart(String scene, Contender contender) implements Part {

  static final String ENERGY = "gas_energy";
  static final String OVERLAP = "gas_overlap";
  static final String LOST = "gas_lost";

  @Override
  public String id() {
    return String.join("/", "gas", scene, contender.id());
  }

  @Override
  public double seconds() {
    return 1;
  }

  @Override
  public List<Row> run() {
    Trial trial = new Trial(scene, contender);
    return trial.rows(() -> measure(trial, Subjects.scene(scene), Subjects.FRAMES));
  }

  /** The worst of all frames; circles are counted as lost at the end. */
  static List<Row> measure(Trial trial, Scene scene, int frames) {
    RecordedRun run = RecordedRun.play(trial.contender(), scene, frames);
    List<Row> rows = new ArrayList<>();
    run.failure().ifPresent(reason -> rows.add(trial.failure(reason)));
    double start = energy(run, scene, 0);
    double drift = 0;
    double overlap = 0;
    for (int frame = 1; frame <= frames; frame++) {
      drift = worse(drift, Math.abs(energy(run, scene, frame) / start - 1));
      overlap = worse(overlap, overlap(run, scene, frame));
    }
    rows.add(trial.row(ENERGY, "max", drift, Trial.ONE, frames));
    rows.add(trial.row(OVERLAP, "max", overlap, Trial.RADII, frames));
    rows.add(trial.row(LOST, "circles", lost(run, scene, frames), Trial.ONE, run.circles()));
    return rows;
  }

  /** The greater of both, or NaN if the next one is. */
  static double worse(double worst, double next) {
    return Double.isNaN(next) ? next : Math.max(worst, next);
  }

  private static double energy(RecordedRun run, Scene scene, int frame) {
    double energy = 0;
    for (int i = 0; i < run.circles(); i++) {
      double speed = run.speed(frame, i);
      energy += scene.traits(Kind.CIRCLE, i).mass() * speed * speed / 2;
    }
    return energy;
  }

  /** Of circles, as a part of the smaller radius. */
  static double overlap(RecordedRun run, Scene scene, int frame) {
    double deepest = 0;
    for (int i = 0; i < run.circles(); i++) {
      for (int j = 0; j < i; j++) {
        double ri = ((Circle) scene.shape(Kind.CIRCLE, i)).radius();
        double rj = ((Circle) scene.shape(Kind.CIRCLE, j)).radius();
        double dx = run.x(frame, i) - run.x(frame, j);
        double dy = run.y(frame, i) - run.y(frame, j);
        deepest = worse(deepest, (ri + rj - Math.hypot(dx, dy)) / Math.min(ri, rj));
      }
    }
    return deepest;
  }

  /** Those whose centre is beyond the bounds. */
  private static int lost(RecordedRun run, Scene scene, int frame) {
    Bounds b = scene.bounds().orElseThrow();
    int lost = 0;
    for (int i = 0; i < run.circles(); i++) {
      double x = run.x(frame, i);
      double y = run.y(frame, i);
      boolean inside = x >= b.xmin() && x <= b.xmax() && y >= b.ymin() && y <= b.ymax();
      lost += inside ? 0 : 1;
    }
    return lost;
  }
}
