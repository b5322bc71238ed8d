// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.methods.Methods;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.Query;
import dev.carom.oracle.SegmentQuery;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/**
 * Questions of one circle against one line, by class. The same class, number and seed give the same
 * questions. Windows without end, and those of the moment 0 alone, are left out, since the
 * published algorithm has no answer for them.
 */
final class Queries {

  /** Those met in a replay of the experiment. */
  static final String REPLAY = "replay";

  /** Where they come from; together, more than 20,000. */
  private static final List<String> REPLAYED = List.of("base-1", "base-2", "base-3");

  static final String HEAD_ON = "head-on";

  private static final long SEED = 20101013;

  /** The names of the classes, and the families that make them. */
  private static final Map<String, List<String>> FAMILIES = families();

  private Queries() {}

  private static Map<String, List<String>> families() {
    Map<String, List<String>> map = new LinkedHashMap<>();
    map.put("ordinary", List.of("seg_poster_cases"));
    map.put("grazing", List.of("seg_near_graze"));
    map.put("shallow", List.of("seg_shallow"));
    map.put("endpoint", List.of("seg_voronoi_edge"));
    map.put("touching", List.of("seg_start_touching"));
    map.put("overlapping", List.of("seg_start_overlapping"));
    map.put("fast", List.of("seg_fast"));
    map.put("slow", List.of("seg_slow"));
    map.put("far", List.of("seg_far"));
    map.put(
        "near-tie",
        List.of("seg_near_tie_end", "seg_near_tie_side", "seg_near_tie_corner", "seg_lattice"));
    return map;
  }

  /** The names of the classes. */
  static List<String> classes() {
    List<String> names = new ArrayList<>(List.of(REPLAY, HEAD_ON));
    names.addAll(FAMILIES.keySet());
    return names;
  }

  static List<SegmentQuery> draw(String name, int count) {
    if (name.equals(REPLAY)) {
      return recorded(count);
    }
    if (name.equals(HEAD_ON)) {
      return headOn(count);
    }
    List<Family<Query>> families =
        Families.all().stream().filter(f -> FAMILIES.get(name).contains(f.name())).toList();
    Draw draw = new Draw(SEED);
    List<SegmentQuery> queries = new ArrayList<>();
    for (int i = 0; queries.size() < count; i++) {
      SegmentQuery query = (SegmentQuery) families.get(i % families.size()).next(draw);
      if (query.end() > 0 && query.end() < Double.POSITIVE_INFINITY) {
        queries.add(query);
      }
    }
    return queries;
  }

  /** Straight at a point of the side, by the sizes and speeds of the experiment. */
  private static List<SegmentQuery> headOn(int count) {
    SplittableRandom random = new SplittableRandom(SEED);
    List<SegmentQuery> queries = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double angle = random.nextDouble(-Math.PI, Math.PI);
      double nx = Math.cos(angle);
      double ny = Math.sin(angle);
      double ax = random.nextDouble(0, 800);
      double ay = random.nextDouble(0, 600);
      double r = random.nextDouble(1, 20);
      double speed = random.nextDouble(1, 100);
      double along = random.nextDouble(5, 15);
      double away = r + speed * random.nextDouble(0.01, 1.1);
      queries.add(
          new SegmentQuery(
              ax,
              ay,
              ax - 20 * ny,
              ay + 20 * nx,
              ax - along * ny + away * nx,
              ay + along * nx + away * ny,
              r,
              -speed * nx,
              -speed * ny,
              1));
    }
    return queries;
  }

  /** From the start of each frame: circles and the lines within their reach in that frame. */
  private static List<SegmentQuery> recorded(int count) {
    List<SegmentQuery> queries = new ArrayList<>();
    for (String name : REPLAYED) {
      if (queries.size() < count) {
        recordAll(Subjects.scene(name), queries);
      }
    }
    return queries.subList(0, count);
  }

  private static void recordAll(Scene scene, List<SegmentQuery> queries) {
    RecordedRun run = RecordedRun.play(Methods.CAROM, scene, Subjects.FRAMES);
    for (int frame = 0; frame <= run.frames(); frame++) {
      for (int i = 0; i < run.circles(); i++) {
        record(scene, run, frame, i, queries);
      }
    }
  }

  private static void record(
      Scene scene, RecordedRun run, int frame, int i, List<SegmentQuery> queries) {
    double x = run.x(frame, i);
    double y = run.y(frame, i);
    double r = ((Circle) scene.shape(Kind.CIRCLE, i)).radius();
    double reach = r + run.speed(frame, i);
    for (int k = 0; k < scene.count(Kind.LINE); k++) {
      Line line = (Line) scene.shape(Kind.LINE, k);
      Vec2 closest = line.closestPoint(new Vec2(x, y));
      if (Math.hypot(closest.x() - x, closest.y() - y) <= reach) {
        double vx = run.vx(frame, i);
        double vy = run.vy(frame, i);
        queries.add(
            new SegmentQuery(line.ax(), line.ay(), line.bx(), line.by(), x, y, r, vx, vy, 1));
      }
    }
  }
}
