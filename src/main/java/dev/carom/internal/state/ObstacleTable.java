// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.Contact;
import dev.carom.internal.util.Kind;
import java.util.Arrays;

/**
 * The things that stand still, in flat arrays, by their {@link Codes}. A code does not change when
 * things are added, and is not used again when its thing is removed.
 */
public final class ObstacleTable {

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
    endOfPegs = Codes.peg(0) + pegs.length / PEG_ROW;
    presentLines = new LiveCodes(Codes.line(0), endOfLines - Codes.line(0));
    presentPegs = new LiveCodes(Codes.peg(0), endOfPegs - Codes.peg(0));
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
    read.endOfLines = Codes.line(0) + lineTraits.length;
    read.endOfPegs = Codes.peg(0) + pegTraits.length;
    read.edited = true;
    read.countSpecials();
    read.presentLines = new LiveCodes(Codes.line(0), lineTraits.length);
    read.presentLines.removed(gone(lines, LINE_ROW), read::isGone);
    read.presentPegs = new LiveCodes(Codes.peg(0), pegTraits.length);
    read.presentPegs.removed(gone(pegs, PEG_ROW), read::isGone);
    return read;
  }

  /** Rows of lines, with those of the walls before them. */
  static double[] byCode(double[] lines) {
    double[] rows = new double[Codes.line(0) * LINE_ROW + lines.length];
    Arrays.fill(rows, 0, Codes.line(0) * LINE_ROW, Double.NaN);
    System.arraycopy(lines, 0, rows, Codes.line(0) * LINE_ROW, lines.length);
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
    for (int code = Codes.line(0); lineTraits != null && code < endOfLines; code++) {
      countSpecial(traits(code), 1);
    }
    for (int code = Codes.peg(0); pegTraits != null && code < endOfPegs; code++) {
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
    double[] walls = new double[Codes.WALLS];
    walls[Codes.LEFT] = xmin;
    walls[Codes.RIGHT] = xmax;
    walls[Codes.BOTTOM] = ymin;
    walls[Codes.TOP] = ymax;
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
      lineTraits = lineTraits == null ? new byte[endOfLines - Codes.line(0)] : lineTraits.clone();
      pegTraits = pegTraits == null ? new byte[pegs.length / PEG_ROW] : pegTraits.clone();
      presentLines = presentLines.copy();
      presentPegs = presentPegs.copy();
    }
  }

  /** Adds an elastic line of no special trait, and returns its code. */
  public int addLine(double ax, double ay, double bx, double by) {
    own();
    int i = endOfLines - Codes.line(0);
    if (i == lineTraits.length) {
      lineTraits = Arrays.copyOf(lineTraits, Math.min(2 * i + 4, Codes.limit(Kind.LINE)));
      lines = Arrays.copyOf(lines, (Codes.line(0) + lineTraits.length) * LINE_ROW);
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
    int i = endOfPegs - Codes.peg(0);
    if (i == pegTraits.length) {
      pegTraits = Arrays.copyOf(pegTraits, Math.min(2 * i + 4, Codes.limit(Kind.PEG)));
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
    if (Codes.kind(code) < Kind.PEG) {
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
    double x = Codes.kind(code) < Kind.PEG ? lines[offset(code) + AX] : pegs[offset(code) + X];
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

  /** A copy of the row of a line or a peg. */
  double[] row(int code) {
    int k = offset(code);
    return Codes.kind(code) < Kind.PEG
        ? Arrays.copyOfRange(lines, k, k + LINE_ROW)
        : Arrays.copyOfRange(pegs, k, k + PEG_ROW);
  }

  /** The place of a line's or a peg's numbers in its array. */
  public int offset(int code) {
    return Codes.kind(code) < Kind.PEG ? code * LINE_ROW : (code - Codes.peg(0)) * PEG_ROW;
  }

  /** The feature that a contact of the detector's code means, as {@link ImpactRows} names it. */
  public int feature(int code, int contact) {
    if (Codes.isPeg(code)) {
      return ImpactRows.CIRCLE;
    }
    return Codes.isWall(code) ? ImpactRows.SIDE : LINE_FEATURES[contact & ~Contact.NOW];
  }

  /** The restitution along the normal; where a circle halts, none. */
  public double restitution(int code) {
    return halts(code) ? 0 : givenRestitution(code);
  }

  /** Whether a circle that hits this halts. */
  public boolean halts(int code) {
    return Codes.isWall(code)
        ? ContactFlags.halts(boundsTraits)
        : specials > 0 && ContactFlags.halts(traits(code));
  }

  /** The restitution as it was given, whatever the response. */
  public double givenRestitution(int code) {
    if (Codes.isWall(code)) {
      return boundsRestitution;
    }
    return Codes.kind(code) < Kind.PEG
        ? lines[offset(code) + LINE_RESTITUTION]
        : pegs[offset(code) + PEG_RESTITUTION];
  }

  public void setRestitution(int code, double e) {
    own();
    if (Codes.isWall(code)) {
      boundsRestitution = e;
    } else if (Codes.kind(code) < Kind.PEG) {
      lines[offset(code) + LINE_RESTITUTION] = e;
    } else {
      pegs[offset(code) + PEG_RESTITUTION] = e;
    }
  }

  /** The {@link ContactFlags} of a line or a peg. */
  public int traits(int code) {
    return Codes.kind(code) < Kind.PEG
        ? ContactFlags.of(lineTraits, code - Codes.line(0))
        : ContactFlags.of(pegTraits, code - Codes.peg(0));
  }

  /** Sets the {@link ContactFlags} of a thing. */
  public void setTraits(int code, int traits) {
    own();
    if (Codes.isWall(code)) {
      boundsTraits = traits;
      return;
    }
    countSpecial(traits(code), -1);
    countSpecial(traits, 1);
    if (Codes.kind(code) < Kind.PEG) {
      lineTraits[code - Codes.line(0)] = (byte) traits;
    } else {
      pegTraits[code - Codes.peg(0)] = (byte) traits;
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
    return specials > 0 && !Codes.isWall(code) && ContactFlags.isSensor(traits(code));
  }

  public boolean isOneWay(int code) {
    return specials > 0 && !Codes.isWall(code) && ContactFlags.isOneWay(traits(code));
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
    if (Codes.isWall(code) || isGone(code)) {
      return 0;
    }
    int k = offset(code);
    double[] numbers = Codes.kind(code) < Kind.PEG ? lines : pegs;
    double extent = Math.max(Math.abs(numbers[k]), Math.abs(numbers[k + 1]));
    return Codes.kind(code) < Kind.PEG
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
    int p = (endOfPegs - Codes.peg(0)) * PEG_ROW;
    return Arrays.equals(lines, 0, l, that.lines, 0, l)
        && Arrays.equals(pegs, 0, p, that.pegs, 0, p);
  }

  private boolean haveSameTraits(ObstacleTable that) {
    for (int code = Codes.line(0); code < endOfLines; code++) {
      if (traits(code) != that.traits(code)) {
        return false;
      }
    }
    for (int code = Codes.peg(0); code < endOfPegs; code++) {
      if (traits(code) != that.traits(code)) {
        return false;
      }
    }
    return true;
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(Arrays.copyOfRange(lines, offset(Codes.line(0)), offset(endOfLines)));
  }
}
