// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The things that stand still, in flat arrays. Each has one code, and the codes stand in the order
 * in which simultaneous impacts are taken: the four walls, then the lines, then the pegs; those of
 * moving circles follow. A code does not change when things are added.
 */
final class Obstacles {

  /** The codes of the walls; the one of the upper wall of an axis follows that of the lower one. */
  static final int LEFT = 0;

  static final int RIGHT = 1;
  static final int BOTTOM = 2;
  static final int TOP = 3;

  /** The number of codes of walls, used or not: the code of the first line. */
  static final int WALLS = 4;

  /** The code of the first peg. */
  static final int PEGS = 1 << 28;

  /** The code of the first moving circle. */
  static final int CIRCLES = 1 << 29;

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

  /** {@link Traits} of lines and pegs, null if none has any. */
  private final byte[] lineTraits;

  private final byte[] pegTraits;

  /** Whether any line or peg has a trait that matters to a search. */
  final boolean special;

  /** The code after the last line, and the one after the last peg. */
  final int endOfLines;

  final int endOfPegs;

  private Obstacles(Scene scene) {
    lines = scene.lines;
    pegs = scene.pegs;
    bounds = scene.bounds;
    boundsRestitution = Traits.halts(scene.boundsTraits) ? 0 : scene.boundsRestitution;
    lineTraits = scene.lineTraits;
    pegTraits = scene.pegTraits;
    special = lineTraits != null || pegTraits != null;
    endOfLines = WALLS + lines.length / Scene.LINE;
    endOfPegs = PEGS + pegs.length / Scene.PEG;
  }

  static Obstacles of(Scene scene) {
    return new Obstacles(scene);
  }

  /** The number of lines and pegs. */
  int size() {
    return (endOfLines - WALLS) + (endOfPegs - PEGS);
  }

  ObstacleKind kind(int code) {
    return code < WALLS ? ObstacleKind.WALL : code < PEGS ? ObstacleKind.LINE : ObstacleKind.PEG;
  }

  /** The number of a thing among those of its kind. */
  int index(int code) {
    return code < WALLS ? code : code < PEGS ? code - WALLS : code - PEGS;
  }

  /** The place of a line's or a peg's numbers in its array. */
  int offset(int code) {
    return code < PEGS ? (code - WALLS) * Scene.LINE : (code - PEGS) * Scene.PEG;
  }

  /** The feature that a contact of the detector's code means. */
  Feature feature(int code, int contact) {
    if (code >= PEGS) {
      return Feature.CIRCLE;
    }
    return code < WALLS ? Feature.SIDE : LINE_FEATURES[contact & ~SegmentSweep.NOW];
  }

  /** The restitution along the normal; where a circle halts, none. */
  double restitution(int code) {
    if (code < WALLS) {
      return boundsRestitution;
    }
    if (special && Traits.halts(traits(code))) {
      return 0;
    }
    return code < PEGS ? lines[offset(code) + 4] : pegs[offset(code) + 3];
  }

  /** The {@link Traits} of a line or a peg. */
  private int traits(int code) {
    return code < PEGS ? Traits.of(lineTraits, code - WALLS) : Traits.of(pegTraits, code - PEGS);
  }

  boolean isSensor(int code) {
    return special && code >= WALLS && Traits.isSensor(traits(code));
  }

  boolean isOneWay(int code) {
    return special && code >= WALLS && Traits.isOneWay(traits(code));
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
