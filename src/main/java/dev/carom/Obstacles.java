// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The things that stand still, in flat arrays. Each has one code, and the codes stand in the order
 * in which simultaneous impacts are taken: the four walls, then the lines, then the pegs.
 */
final class Obstacles {

  /** The codes of the walls; the one of the upper wall of an axis follows that of the lower one. */
  static final int LEFT = 0;

  static final int RIGHT = 1;
  static final int BOTTOM = 2;
  static final int TOP = 3;

  /** The number of codes of walls, used or not. */
  static final int WALLS = 4;

  private static final Feature[] LINE_FEATURES = {
    null, Feature.SIDE, Feature.SIDE, Feature.START, Feature.END
  };

  /** {@link Scene#LINE} doubles a line. */
  final double[] lines;

  /** {@link Scene#PEG} doubles a peg. */
  final double[] pegs;

  /** Null in an open scene. */
  final Bounds bounds;

  private final double boundsRestitution;

  /** The code of the first peg, and the code after the last one. */
  final int firstPeg;

  final int end;

  Obstacles(double[] lines, double[] pegs, Bounds bounds, double boundsRestitution) {
    this.lines = lines;
    this.pegs = pegs;
    this.bounds = bounds;
    this.boundsRestitution = boundsRestitution;
    firstPeg = WALLS + lines.length / Scene.LINE;
    end = firstPeg + pegs.length / Scene.PEG;
  }

  static Obstacles of(Scene scene) {
    return new Obstacles(scene.lines, scene.pegs, scene.bounds, scene.boundsRestitution);
  }

  /** The number of lines and pegs. */
  int size() {
    return end - WALLS;
  }

  ObstacleKind kind(int code) {
    return code < WALLS
        ? ObstacleKind.WALL
        : code < firstPeg ? ObstacleKind.LINE : ObstacleKind.PEG;
  }

  /** The number of a thing among those of its kind. */
  int index(int code) {
    return code < WALLS ? code : code < firstPeg ? code - WALLS : code - firstPeg;
  }

  /** The place of a line's or a peg's numbers in its array. */
  int offset(int code) {
    return code < firstPeg ? (code - WALLS) * Scene.LINE : (code - firstPeg) * Scene.PEG;
  }

  /** The feature that a contact of the detector's code means. */
  Feature feature(int code, int contact) {
    if (code >= firstPeg) {
      return Feature.CIRCLE;
    }
    return code < WALLS ? Feature.SIDE : LINE_FEATURES[contact & ~SegmentSweep.NOW];
  }

  double restitution(int code) {
    if (code < WALLS) {
      return boundsRestitution;
    }
    return code < firstPeg ? lines[offset(code) + 4] : pegs[offset(code) + 3];
  }

  /** The largest absolute coordinate of all lines and pegs; 0 without any. */
  double extent() {
    double extent = 0;
    for (int k = 0; k < lines.length; k += Scene.LINE) {
      for (int i = 0; i < 4; i++) {
        extent = Math.max(extent, Math.abs(lines[k + i]));
      }
    }
    for (int k = 0; k < pegs.length; k += Scene.PEG) {
      extent = Math.max(extent, Math.max(Math.abs(pegs[k]), Math.abs(pegs[k + 1])));
    }
    return extent;
  }
}
