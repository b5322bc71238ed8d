// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.WallSweep;
import dev.carom.internal.util.Kind;
import java.util.Arrays;

/**
 * The things that stand still, in flat arrays. Each has one code, and the codes stand in the order
 * in which simultaneous impacts are taken: the four walls, then the lines, then the pegs; those of
 * moving circles follow. A code does not change when things are added, and is not used again when
 * its thing is removed.
 */
public final class ObstacleTable {

  /** The codes of the walls are their ids. */
  public static final int LEFT = WallSweep.LEFT;

  public static final int RIGHT = WallSweep.RIGHT;
  public static final int BOTTOM = WallSweep.BOTTOM;
  public static final int TOP = WallSweep.TOP;

  /** The number of codes of walls, used or not: the code of the first line. */
  public static final int WALLS = 4;

  /** The code of the first peg. */
  public static final int PEGS = 1 << 28;

  /** The code of the first moving circle. */
  public static final int CIRCLES = 1 << 29;

  /** How many lines have codes, those that were removed included, and how many pegs. */
  public static final int LINE_LIMIT = PEGS - WALLS;

  public static final int PEG_LIMIT = CIRCLES - PEGS;

  /** Doubles of one row of {@link #lines}. */
  public static final int LINE_ROW = 5;

  // Their places in the row.
  public static final int AX = 0;
  public static final int AY = 1;
  public static final int BX = 2;
  public static final int BY = 3;
  static final int LINE_RESTITUTION = 4;

  /** From the start of a line to its end, in a row. */
  public static final int END = BX - AX;

  /** Doubles of one row of {@link #pegs}. */
  public static final int PEG_ROW = 4;

  // Their places in the row.
  public static final int X = 0;
  public static final int Y = 1;
  public static final int RADIUS = 2;
  static final int PEG_RESTITUTION = 3;

  /** By the part of a line that a contact names; the first is of none. */
  private static final int[] LINE_FEATURES = {
    0, ImpactRows.SIDE, ImpactRows.SIDE, ImpactRows.START, ImpactRows.END
  };

  /**
   * A row for each code from 0 on: that of a line; NaN for one that was removed, and for the walls,
   * which are no lines.
   */
  public double[] lines;

  /** A row for each peg; NaN for one that was removed. */
  public double[] pegs;

  /** Where the walls stand, by their codes; null without bounds. */
  public final double[] walls;

  public double boundsRestitution;
  public int boundsTraits;

  /** {@link ContactFlags} of lines and pegs, null if none has any. */
  byte[] lineTraits;

  byte[] pegTraits;

  /** The code after the last line, and the one after the last peg. */
  public int endOfLines;

  public int endOfPegs;

  /** Whether another object, or a scene, uses the same arrays. */
  private boolean shared = true;

  /** Whether anything is not as in the scene. */
  private boolean edited;

  /** The codes of the lines and of the pegs. */
  private LiveCodes presentLines;

  private LiveCodes presentPegs;

  /** The number of lines and pegs that have traits, and of those that are sensors. */
  private int specials;

  private int sensors;

  private ObstacleTable(SceneData scene) {
    lines = scene.lines;
    pegs = scene.pegs;
    walls = scene.walls;
    boundsRestitution = scene.boundsRestitution;
    boundsTraits = scene.boundsTraits;
    lineTraits = scene.lineTraits;
    pegTraits = scene.pegTraits;
    endOfLines = lines.length / LINE_ROW;
    endOfPegs = PEGS + pegs.length / PEG_ROW;
    presentLines = new LiveCodes(WALLS, endOfLines - WALLS);
    presentPegs = new LiveCodes(PEGS, endOfPegs - PEGS);
    countSpecials();
  }

  private ObstacleTable(ObstacleTable other) {
    walls = other.walls;
    set(other);
  }

  private ObstacleTable(double[] walls) {
    this.walls = walls;
  }

  /** Those of a snapshot; the traits are one for each line and each peg. */
  public static ObstacleTable of(
      double[] walls,
      double boundsRestitution,
      int boundsTraits,
      double[] lines,
      byte[] lineTraits,
      double[] pegs,
      byte[] pegTraits) {
    ObstacleTable read = new ObstacleTable(walls);
    read.boundsRestitution = boundsRestitution;
    read.boundsTraits = boundsTraits;
    read.lines = byCode(lines);
    read.pegs = pegs;
    read.lineTraits = lineTraits;
    read.pegTraits = pegTraits;
    read.endOfLines = WALLS + lineTraits.length;
    read.endOfPegs = PEGS + pegTraits.length;
    read.edited = true;
    read.countSpecials();
    read.presentLines = new LiveCodes(WALLS, lineTraits.length);
    read.presentLines.removed(gone(lines, LINE_ROW), read::isGone);
    read.presentPegs = new LiveCodes(PEGS, pegTraits.length);
    read.presentPegs.removed(gone(pegs, PEG_ROW), read::isGone);
    return read;
  }

  /** Rows of lines, with those of the walls before them. */
  static double[] byCode(double[] lines) {
    double[] rows = new double[WALLS * LINE_ROW + lines.length];
    Arrays.fill(rows, 0, WALLS * LINE_ROW, Double.NaN);
    System.arraycopy(lines, 0, rows, WALLS * LINE_ROW, lines.length);
    return rows;
  }

  private static int gone(double[] numbers, int row) {
    int gone = 0;
    for (int k = 0; k < numbers.length; k += row) {
      gone += Double.isNaN(numbers[k]) ? 1 : 0;
    }
    return gone;
  }

  private void countSpecials() {
    for (int code = WALLS; lineTraits != null && code < endOfLines; code++) {
      countSpecial(traits(code), 1);
    }
    for (int code = PEGS; pegTraits != null && code < endOfPegs; code++) {
      countSpecial(traits(code), 1);
    }
  }

  private void countSpecial(int traits, int one) {
    specials += traits != 0 ? one : 0;
    sensors += ContactFlags.isSensor(traits) ? one : 0;
  }

  /** Those of a scene. */
  public static ObstacleTable of(SceneData scene) {
    return new ObstacleTable(scene);
  }

  /** A copy; arrays are shared until one of the two is changed. */
  public ObstacleTable copy() {
    return new ObstacleTable(this);
  }

  /** Where the walls of a rectangle stand, by their codes. */
  public static double[] walls(double xmin, double ymin, double xmax, double ymax) {
    double[] walls = new double[WALLS];
    walls[LEFT] = xmin;
    walls[RIGHT] = xmax;
    walls[BOTTOM] = ymin;
    walls[TOP] = ymax;
    return walls;
  }

  /** Takes over what another one holds, with the same walls. */
  public void set(ObstacleTable other) {
    other.shared = true;
    shared = true;
    edited = other.edited;
    lines = other.lines;
    pegs = other.pegs;
    boundsRestitution = other.boundsRestitution;
    boundsTraits = other.boundsTraits;
    lineTraits = other.lineTraits;
    pegTraits = other.pegTraits;
    endOfLines = other.endOfLines;
    endOfPegs = other.endOfPegs;
    specials = other.specials;
    sensors = other.sensors;
    presentLines = other.presentLines;
    presentPegs = other.presentPegs;
  }

  /** Before a change: makes the arrays this object's own. */
  private void own() {
    edited = true;
    if (shared) {
      shared = false;
      lines = lines.clone();
      pegs = pegs.clone();
      lineTraits = lineTraits == null ? new byte[endOfLines - WALLS] : lineTraits.clone();
      pegTraits = pegTraits == null ? new byte[pegs.length / PEG_ROW] : pegTraits.clone();
      presentLines = presentLines.copy();
      presentPegs = presentPegs.copy();
    }
  }

  /** Adds an elastic line of no special trait, and returns its code. */
  public int addLine(double ax, double ay, double bx, double by) {
    own();
    int i = endOfLines - WALLS;
    if (i == lineTraits.length) {
      lineTraits = Arrays.copyOf(lineTraits, Math.min(2 * i + 4, LINE_LIMIT));
      lines = Arrays.copyOf(lines, (WALLS + lineTraits.length) * LINE_ROW);
    }
    int code = endOfLines++;
    presentLines.add(code);
    moveLine(code, ax, ay, bx, by);
    lines[offset(code) + LINE_RESTITUTION] = 1;
    lineTraits[i] = 0;
    return code;
  }

  public void moveLine(int code, double ax, double ay, double bx, double by) {
    own();
    int k = offset(code);
    lines[k + AX] = ax;
    lines[k + AY] = ay;
    lines[k + BX] = bx;
    lines[k + BY] = by;
  }

  /** Adds an elastic peg of no special trait, and returns its code. */
  public int addPeg(double x, double y, double radius) {
    own();
    int i = endOfPegs - PEGS;
    if (i == pegTraits.length) {
      pegTraits = Arrays.copyOf(pegTraits, Math.min(2 * i + 4, PEG_LIMIT));
      pegs = Arrays.copyOf(pegs, pegTraits.length * PEG_ROW);
    }
    int code = endOfPegs++;
    presentPegs.add(code);
    movePeg(code, x, y, radius);
    pegs[offset(code) + PEG_RESTITUTION] = 1;
    pegTraits[i] = 0;
    return code;
  }

  public void movePeg(int code, double x, double y, double radius) {
    own();
    int k = offset(code);
    pegs[k + X] = x;
    pegs[k + Y] = y;
    pegs[k + RADIUS] = radius;
  }

  /** Removes a line or a peg: no sweep finds it any more. */
  public void remove(int code) {
    own();
    int k = offset(code);
    setTraits(code, 0);
    if (code < PEGS) {
      Arrays.fill(lines, k, k + LINE_ROW, Double.NaN);
      presentLines.removed(1, this::isGone);
    } else {
      Arrays.fill(pegs, k, k + PEG_ROW, Double.NaN);
      presentPegs.removed(1, this::isGone);
    }
  }

  /** Whether a line or a peg was removed. */
  public boolean isGone(int code) {
    if (!edited) {
      return false;
    }
    double x = code < PEGS ? lines[offset(code) + AX] : pegs[offset(code) + X];
    return Double.isNaN(x);
  }

  /** The number of lines and pegs. */
  public int size() {
    return presentLines.count() + presentPegs.count();
  }

  /** The codes of the lines, of some that are gone too, until the next change. */
  public LiveCodes presentLines() {
    return presentLines;
  }

  /** The codes of the pegs, of some that are gone too, until the next change. */
  public LiveCodes presentPegs() {
    return presentPegs;
  }

  /** The {@link Kind} of a thing. */
  public int kind(int code) {
    return code < WALLS ? Kind.WALL : code < PEGS ? Kind.LINE : Kind.PEG;
  }

  /** A copy of the row of a line or a peg. */
  double[] row(int code) {
    int k = offset(code);
    return code < PEGS
        ? Arrays.copyOfRange(lines, k, k + LINE_ROW)
        : Arrays.copyOfRange(pegs, k, k + PEG_ROW);
  }

  /** The code of a wall, a line or a peg, by its {@link Kind} and its number of that kind. */
  public static int code(int kind, int index) {
    return switch (kind) {
      case Kind.WALL -> index;
      case Kind.LINE -> WALLS + index;
      default -> PEGS + index;
    };
  }

  /** The number of a thing among those of its kind. */
  public int index(int code) {
    return code < WALLS ? code : code < PEGS ? code - WALLS : code - PEGS;
  }

  /** The place of a line's or a peg's numbers in its array. */
  public int offset(int code) {
    return code < PEGS ? code * LINE_ROW : (code - PEGS) * PEG_ROW;
  }

  /** The feature that a contact of the detector's code means, as {@link ImpactRows} names it. */
  public int feature(int code, int contact) {
    if (code >= PEGS) {
      return ImpactRows.CIRCLE;
    }
    return code < WALLS ? ImpactRows.SIDE : LINE_FEATURES[contact & ~Contact.NOW];
  }

  /** The restitution along the normal; where a circle halts, none. */
  public double restitution(int code) {
    return halts(code) ? 0 : givenRestitution(code);
  }

  /** Whether a circle that hits this halts. */
  public boolean halts(int code) {
    return code < WALLS
        ? ContactFlags.halts(boundsTraits)
        : specials > 0 && ContactFlags.halts(traits(code));
  }

  /** The restitution as it was given, whatever the response. */
  public double givenRestitution(int code) {
    if (code < WALLS) {
      return boundsRestitution;
    }
    return code < PEGS
        ? lines[offset(code) + LINE_RESTITUTION]
        : pegs[offset(code) + PEG_RESTITUTION];
  }

  public void setRestitution(int code, double e) {
    own();
    if (code < WALLS) {
      boundsRestitution = e;
    } else if (code < PEGS) {
      lines[offset(code) + LINE_RESTITUTION] = e;
    } else {
      pegs[offset(code) + PEG_RESTITUTION] = e;
    }
  }

  /** The {@link ContactFlags} of a line or a peg. */
  public int traits(int code) {
    return code < PEGS
        ? ContactFlags.of(lineTraits, code - WALLS)
        : ContactFlags.of(pegTraits, code - PEGS);
  }

  /** Sets the {@link ContactFlags} of a thing. */
  public void setTraits(int code, int traits) {
    own();
    if (code < WALLS) {
      boundsTraits = traits;
      return;
    }
    countSpecial(traits(code), -1);
    countSpecial(traits, 1);
    if (code < PEGS) {
      lineTraits[code - WALLS] = (byte) traits;
    } else {
      pegTraits[code - PEGS] = (byte) traits;
    }
  }

  /** Whether any line or peg has a trait. */
  public boolean areSpecial() {
    return specials > 0;
  }

  /** Whether any line or peg is a sensor. */
  public boolean haveSensors() {
    return sensors > 0;
  }

  public boolean isSensor(int code) {
    return specials > 0 && code >= WALLS && ContactFlags.isSensor(traits(code));
  }

  public boolean isOneWay(int code) {
    return specials > 0 && code >= WALLS && ContactFlags.isOneWay(traits(code));
  }

  /** The largest absolute coordinate of all lines and pegs; 0 without any. */
  public double extent() {
    double extent = 0;
    for (int i = 0; i < presentLines.size(); i++) {
      extent = Math.max(extent, extent(presentLines.get(i)));
    }
    for (int i = 0; i < presentPegs.size(); i++) {
      extent = Math.max(extent, extent(presentPegs.get(i)));
    }
    return extent;
  }

  /** The largest absolute coordinate of a line or a peg; 0 for one that was removed. */
  public double extent(int code) {
    if (code < WALLS || isGone(code)) {
      return 0;
    }
    int k = offset(code);
    double[] numbers = code < PEGS ? lines : pegs;
    double extent = Math.max(Math.abs(numbers[k]), Math.abs(numbers[k + 1]));
    return code < PEGS
        ? Math.max(extent, Math.max(Math.abs(numbers[k + 2]), Math.abs(numbers[k + 3])))
        : extent;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ObstacleTable that
        && Arrays.equals(walls, that.walls)
        && Double.compare(boundsRestitution, that.boundsRestitution) == 0
        && boundsTraits == that.boundsTraits
        && endOfLines == that.endOfLines
        && endOfPegs == that.endOfPegs
        && haveSameNumbers(that)
        && haveSameTraits(that);
  }

  private boolean haveSameNumbers(ObstacleTable that) {
    int l = endOfLines * LINE_ROW;
    int p = (endOfPegs - PEGS) * PEG_ROW;
    return Arrays.equals(lines, 0, l, that.lines, 0, l)
        && Arrays.equals(pegs, 0, p, that.pegs, 0, p);
  }

  private boolean haveSameTraits(ObstacleTable that) {
    for (int code = WALLS; code < endOfLines; code++) {
      if (traits(code) != that.traits(code)) {
        return false;
      }
    }
    for (int code = PEGS; code < endOfPegs; code++) {
      if (traits(code) != that.traits(code)) {
        return false;
      }
    }
    return true;
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(Arrays.copyOfRange(lines, offset(WALLS), offset(endOfLines)));
  }
}
