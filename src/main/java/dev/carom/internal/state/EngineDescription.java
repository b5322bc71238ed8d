// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * The search structures that a world chose for its scene.
 *
 * @param collide whether its circles collide with each other
 * @param obstacles the number of lines and pegs that rest
 * @param moving the number of those that move, or moved before
 * @param grids the number of grids, one for each power of two among the circles' radii; 0 if every
 *     obstacle is tested
 * @param cells the number of cells of all grids together
 */
public record EngineDescription(boolean collide, int obstacles, int moving, int grids, int cells) {

  @Override
  public String toString() {
    return moving == 0 ? rest() : rest() + ", and " + moving + " moving";
  }

  private String rest() {
    String circles = collide ? "circles that collide" : "circles that ignore each other";
    if (obstacles == 0) {
      return circles + ", no lines or pegs";
    }
    String things = obstacles == 1 ? "1 line or peg" : obstacles + " lines and pegs";
    if (grids == 0) {
      return "%s, %s without a grid".formatted(circles, things);
    }
    return "%s, %s in %s %s of %s cells"
        .formatted(circles, things, grids, grids == 1 ? "grid" : "grids", cells);
  }
}
