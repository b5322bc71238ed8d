// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Obstacle;
import dev.carom.Outline;
import dev.carom.Scene;
import dev.carom.Vec2;
import java.util.List;
import java.util.stream.IntStream;

/** The lines of which things of the kind of lines are made. */
public final class Sides {

  private Sides() {}

  /** A line itself, or the sides of an outline in their order. */
  public static List<Line> of(Obstacle lineOrOutline) {
    if (lineOrOutline instanceof Line line) {
      return List.of(line);
    }
    Outline outline = (Outline) lineOrOutline;
    int sides = outline.points().size() - (outline.solid() ? 0 : 1);
    return IntStream.range(0, sides).mapToObj(outline::side).toList();
  }

  /** All lines of a scene and all sides of its outlines. */
  public static List<Line> of(Scene scene) {
    return IntStream.range(0, scene.count(Kind.LINE))
        .mapToObj(i -> of(scene.shape(Kind.LINE, i)))
        .flatMap(List::stream)
        .toList();
  }

  /** An outline elsewhere. */
  public static Outline moved(Outline outline, Vec2 by) {
    return new Outline(
        outline.points().stream().map(p -> new Vec2(p.x() + by.x(), p.y() + by.y())).toList(),
        outline.solid());
  }

  /** Whether a scene has outlines. */
  public static boolean areJoined(Scene scene) {
    return IntStream.range(0, scene.count(Kind.LINE))
        .anyMatch(i -> scene.shape(Kind.LINE, i) instanceof Outline);
  }
}
