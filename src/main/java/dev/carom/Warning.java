// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.util.Check;
import java.util.List;

/**
 * A {@code Warning} names a circle of a scene that overlaps something at time 0: legal, but likely
 * a mistake. See {@link Scene#warnings()}.
 *
 * <pre>{@code
 * Scene scene = Scene.builder().peg(50, 50, 10).circle(60, 50, 5, 1, 0).build();
 * for (Warning warning : scene.warnings()) {
 *   System.out.println("circle " + warning.circle() + ", " + warning.kind()); // circle 0, PEG
 * }
 * }</pre>
 *
 * @param circle the number of the circle
 * @param kind the kind of the other thing
 * @param id its number; of a wall 0 left, 1 right, 2 bottom, 3 top
 * @param distance the distance of the circle's centre from the wall, the line, or the other centre,
 *     rounded; negative beyond a wall
 * @param expected the least distance at which the two do not overlap, more than the distance
 */
public record Warning(int circle, Kind kind, int id, double distance, double expected) {

  private static final List<String> WALLS = List.of("left", "right", "bottom", "top");

  /**
   * Checks that the kind is not null.
   *
   * @param circle the id of the circle
   * @param kind the kind of thing that it overlaps
   * @param id the id of the thing
   * @param distance their distance
   * @param expected the least distance without an overlap
   */
  public Warning {
    Check.notNull("kind", kind);
  }

  /** Returns a sentence for people. */
  @Override
  public String toString() {
    String thing = kind == Kind.WALL ? "the " + WALLS.get(id) + " wall" : kind.nameOf(id);
    boolean isRound = kind == Kind.PEG || kind == Kind.CIRCLE;
    return "%s: distance from %s is %s: expected at least %s, %s"
        .formatted(
            Kind.CIRCLE.nameOf(circle),
            thing,
            distance,
            expected,
            isRound ? "the sum of both radii" : "its radius");
  }
}
