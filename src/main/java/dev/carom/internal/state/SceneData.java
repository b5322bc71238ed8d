// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.Objects;

/**
 * What a scene holds, in flat arrays that no one changes. Circles stand in rows in the order of
 * their numbers; lines, pegs and walls as in {@link ObstacleTable}.
 */
public final class SceneData {

  /** Doubles of one row of {@link #circles}. */
  public static final int CIRCLE_ROW = 6;

  // Their places in the row.
  public static final int X = 0;
  public static final int Y = 1;
  public static final int RADIUS = 2;
  static final int VX = 3;
  static final int VY = 4;
  static final int RESTITUTION = 5;

  public final double[] circles;
  public final double[] masses;

  /** Rows of the lines, by their codes. */
  public final double[] lines;

  public final double[] pegs;

  /** Where the walls stand, by their codes; null without bounds. */
  public final double[] walls;

  public final double boundsRestitution;
  public final boolean collide;

  /** See {@link ContactFlags}. */
  public final byte[] circleTraits;

  public final byte[] lineTraits;
  public final byte[] pegTraits;
  public final int boundsTraits;

  SceneData(SceneDataBuilder from) {
    circles = from.circles.toArray();
    masses = from.masses.toArray();
    lines = ObstacleTable.byCode(from.lines.toArray());
    pegs = from.pegs.toArray();
    circleTraits = from.circles.traits();
    lineTraits = from.lines.traits();
    pegTraits = from.pegs.traits();
    collide = from.collide;
    double[] b = from.bounds.toArray();
    boolean closed = b.length > 0;
    walls = closed ? ObstacleTable.walls(b[0], b[1], b[2], b[3]) : null;
    boundsRestitution = closed ? b[4] : 1;
    boundsTraits = closed ? from.bounds.lastTraits() : 0;
  }

  public int circleCount() {
    return circles.length / CIRCLE_ROW;
  }

  public int lineCount() {
    return lines.length / ObstacleTable.LINE_ROW - Codes.line(0);
  }

  public int pegCount() {
    return pegs.length / ObstacleTable.PEG_ROW;
  }

  public double x(int circle) {
    return circles[circle * CIRCLE_ROW + X];
  }

  public double y(int circle) {
    return circles[circle * CIRCLE_ROW + Y];
  }

  public double radius(int circle) {
    return circles[circle * CIRCLE_ROW + RADIUS];
  }

  public double vx(int circle) {
    return circles[circle * CIRCLE_ROW + VX];
  }

  public double vy(int circle) {
    return circles[circle * CIRCLE_ROW + VY];
  }

  public double restitution(int circle) {
    return circles[circle * CIRCLE_ROW + RESTITUTION];
  }

  public double lineRestitution(int line) {
    return lines[lineAt(line) + ObstacleTable.LINE_RESTITUTION];
  }

  public double pegRestitution(int peg) {
    return pegs[pegAt(peg) + ObstacleTable.PEG_RESTITUTION];
  }

  /** Where the row of a line begins. */
  public static int lineAt(int line) {
    return (Codes.line(line)) * ObstacleTable.LINE_ROW;
  }

  /** Where the row of a peg begins. */
  public static int pegAt(int peg) {
    return peg * ObstacleTable.PEG_ROW;
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
