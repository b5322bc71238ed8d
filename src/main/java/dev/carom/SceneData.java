// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;
import java.util.Objects;

/**
 * What a scene holds, in flat arrays that no one changes. Circles stand in rows in the order of
 * their numbers; lines, pegs and walls as in {@link Obstacles}.
 */
final class SceneData {

  /** Doubles of one row of {@link #circles}. */
  static final int CIRCLE_ROW = 6;

  // Their places in the row.
  static final int X = 0;
  static final int Y = 1;
  static final int RADIUS = 2;
  static final int VX = 3;
  static final int VY = 4;
  static final int RESTITUTION = 5;

  final double[] circles;
  final double[] masses;

  /** Rows of the lines, by their codes. */
  final double[] lines;

  final double[] pegs;

  /** Where the walls stand, by their codes; null without bounds. */
  final double[] walls;

  final double boundsRestitution;
  final boolean collide;

  /** See {@link Traits}. */
  final byte[] circleTraits;

  final byte[] lineTraits;
  final byte[] pegTraits;
  final int boundsTraits;

  SceneData(SceneDataBuilder from) {
    circles = from.circles.toArray();
    masses = from.masses.toArray();
    lines = Obstacles.byCode(from.lines.toArray());
    pegs = from.pegs.toArray();
    circleTraits = from.circles.traits();
    lineTraits = from.lines.traits();
    pegTraits = from.pegs.traits();
    collide = from.collide;
    double[] b = from.bounds.toArray();
    boolean closed = b.length > 0;
    walls = closed ? Obstacles.walls(b[0], b[1], b[2], b[3]) : null;
    boundsRestitution = closed ? b[4] : 1;
    boundsTraits = closed ? from.bounds.lastTraits() : 0;
  }

  int circleCount() {
    return circles.length / CIRCLE_ROW;
  }

  int lineCount() {
    return lines.length / Obstacles.LINE_ROW - Obstacles.WALLS;
  }

  int pegCount() {
    return pegs.length / Obstacles.PEG_ROW;
  }

  double x(int circle) {
    return circles[circle * CIRCLE_ROW + X];
  }

  double y(int circle) {
    return circles[circle * CIRCLE_ROW + Y];
  }

  double radius(int circle) {
    return circles[circle * CIRCLE_ROW + RADIUS];
  }

  double vx(int circle) {
    return circles[circle * CIRCLE_ROW + VX];
  }

  double vy(int circle) {
    return circles[circle * CIRCLE_ROW + VY];
  }

  double restitution(int circle) {
    return circles[circle * CIRCLE_ROW + RESTITUTION];
  }

  double lineRestitution(int line) {
    return lines[lineAt(line) + Obstacles.LINE_RESTITUTION];
  }

  double pegRestitution(int peg) {
    return pegs[pegAt(peg) + Obstacles.PEG_RESTITUTION];
  }

  /** Where the row of a line begins. */
  static int lineAt(int line) {
    return (Obstacles.WALLS + line) * Obstacles.LINE_ROW;
  }

  /** Where the row of a peg begins. */
  static int pegAt(int peg) {
    return peg * Obstacles.PEG_ROW;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof SceneData that
        && Arrays.equals(circles, that.circles)
        && Arrays.equals(masses, that.masses)
        && collide == that.collide
        && Arrays.equals(lines, that.lines)
        && Arrays.equals(pegs, that.pegs)
        && Arrays.equals(circleTraits, that.circleTraits)
        && Arrays.equals(lineTraits, that.lineTraits)
        && Arrays.equals(pegTraits, that.pegTraits)
        && boundsTraits == that.boundsTraits
        && Arrays.equals(walls, that.walls)
        && Double.compare(boundsRestitution, that.boundsRestitution) == 0;
  }

  @Override
  public int hashCode() {
    return Objects.hash(
        Arrays.hashCode(circles),
        Arrays.hashCode(lines),
        Arrays.hashCode(pegs),
        Arrays.hashCode(walls));
  }
}
