// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.sweep.PegShape;
import dev.carom.internal.sweep.Polygon;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.KindNumber;
import dev.carom.internal.util.Part;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * The obstacles: the walls, and a table of rows for each other kind, found by their {@link Codes}.
 * The row of a moving obstacle says where it was at one time, which {@link ObstacleMotions} holds.
 */
public final class ObstacleTable {

  /** The shape of each kind that has rows, by its {@link KindNumber}; walls have none. */
  private static final ObstacleShape[] SHAPES = {null, LineShape.INSTANCE, PegShape.INSTANCE};

  /** The most numbers that an obstacle of any kind has, its restitution not counted. */
  public static final int MOST_NUMBERS =
      kindsOfRows().map(kind -> SHAPES[kind].restitution).max().orElseThrow();

  /** The coordinate of each wall, by its code; null without bounds. */
  public final double[] walls;

  public double boundsRestitution = 1;
  public int boundsTraits;
  private long boundsFilter = FilterBits.DEFAULT;

  /** The rows of each kind, by the {@linkplain Codes#part part} of the codes. */
  private final ObstacleRows[] byPart = new ObstacleRows[Codes.PARTS];

  /** The rows of each kind, by its {@link KindNumber}; null for the walls. */
  private final ObstacleRows[] byKind = new ObstacleRows[SHAPES.length];

  /** The kinds that have rows, in the order of their codes. */
  public final List<ObstacleRows> kinds;

  public final ObstacleRows lines;

  /** The number of obstacles with traits, and the number of sensors. */
  private int specials;

  private int sensors;

  /** Whether any may have a filter other than the default. */
  private boolean filtered;

  /** The obstacles that move, or moved before; never null. */
  private ObstacleMotions motions = ObstacleMotions.NONE;

  /** The time of the world that a question counts as 0, see {@link #beginQuestion}. */
  private double epoch;

  /** The motions apart from those that a question has followed to their ends; null for these. */
  private ObstacleMotions beforeQuestion;

  /** Room for the motions of a question. */
  private ObstacleMotions ofQuestions = ObstacleMotions.NONE;

  private ObstacleTable(double[] walls, ObstacleRows... rows) {
    this.walls = walls;
    kinds = List.of(rows);
    System.arraycopy(rows, 0, byKind, KindNumber.LINE, rows.length);
    lines = byKind[KindNumber.LINE];
    for (ObstacleRows each : rows) {
      byPart[Codes.part(each.first())] = each;
    }
  }

  /** A table of no obstacles but walls, given by their coordinates; null for none. */
  public static ObstacleTable empty(double[] walls) {
    return new ObstacleTable(
        walls,
        kindsOfRows()
            .mapToObj(kind -> new ObstacleRows(kind, SHAPES[kind]))
            .toArray(ObstacleRows[]::new));
  }

  /** The kinds that have rows, in the order of their codes. */
  public static IntStream kindsOfRows() {
    return IntStream.range(KindNumber.LINE, SHAPES.length);
  }

  /** The number of doubles in a row of a kind. */
  public static int width(int kind) {
    return SHAPES[kind].row;
  }

  /** Refuses numbers that cannot be the row of obstacle i of a kind. */
  public static void checkRow(int kind, int i, double... row) {
    for (double number : row) {
      Check.finite("a number of " + KindNumber.nameOf(kind, i), number);
    }
    SHAPES[kind].checkRadius(row);
    Check.notNegative("restitution", row[SHAPES[kind].restitution]);
  }

  /** The shape of a kind that has rows. */
  public static ObstacleShape shape(int kind) {
    return SHAPES[kind];
  }

  /** A copy of the obstacles of a scene. */
  public static ObstacleTable of(SceneData scene) {
    return scene.obstacles.copy();
  }

  /** A copy; arrays are shared until one of the two is changed. */
  public ObstacleTable copy() {
    return within(walls);
  }

  /** A copy of all obstacles but walls, with other walls. */
  ObstacleTable within(double[] itsWalls) {
    ObstacleTable copy = empty(itsWalls);
    copy.set(this);
    return copy;
  }

  /** The coordinates of the walls of a rectangle, by their codes. */
  public static double[] walls(double xmin, double ymin, double xmax, double ymax) {
    double[] walls = new double[Codes.WALLS];
    walls[Codes.LEFT] = xmin;
    walls[Codes.RIGHT] = xmax;
    walls[Codes.BOTTOM] = ymin;
    walls[Codes.TOP] = ymax;
    return walls;
  }

  /** Copies the obstacles of another table, its walls apart. */
  public void set(ObstacleTable other) {
    boundsRestitution = other.boundsRestitution;
    boundsTraits = other.boundsTraits;
    boundsFilter = other.boundsFilter;
    motions = other.motions.shared();
    for (int i = 0; i < kinds.size(); i++) {
      kinds.get(i).set(other.kinds.get(i));
    }
    countSpecials();
  }

  private void countSpecials() {
    specials = 0;
    sensors = 0;
    filtered = boundsFilter != FilterBits.DEFAULT;
    for (ObstacleRows rows : kinds) {
      specials += rows.specials();
      sensors += rows.sensors();
      filtered |= rows.areFiltered();
    }
  }

  // The obstacles.

  /** The rows of a kind. */
  public ObstacleRows ofKind(int kind) {
    return byKind[kind];
  }

  /** The rows of the kind of an obstacle that is no wall. */
  public ObstacleRows of(int code) {
    return byPart[Codes.part(code)];
  }

  /** Whether an obstacle other than a wall was removed. */
  public boolean isGone(int code) {
    return of(code).isGone(code);
  }

  /** The number of obstacles, walls not counted. */
  public int size() {
    int size = 0;
    for (int i = 0; i < kinds.size(); i++) { // an iterator would be allocated until compiled
      size += kinds.get(i).present().count();
    }
    return size;
  }

  /** The number of obstacles that never moved, walls not counted. */
  public int staticSize() {
    return size() - motions.count();
  }

  /** Whether an obstacle is there, or a wall: its code is below the end of its kind. */
  public boolean isThere(int code) {
    return Codes.isWall(code) ? isWallThere(code) : !isGone(code);
  }

  /** Whether there is a wall on a side: bounds may be open. */
  private boolean isWallThere(int code) {
    return walls != null && Double.isFinite(walls[code]);
  }

  /** The largest absolute coordinate of the walls; 0 if there are none. */
  public double extentOfBounds() {
    return codes(KindNumber.WALL).mapToDouble(code -> Math.abs(walls[code])).max().orElse(0);
  }

  /** The number of live obstacles of a {@link KindNumber}. */
  public int count(int kind) {
    return kind == KindNumber.WALL ? (int) codes(kind).count() : ofKind(kind).obstacles();
  }

  /** One more than the id of the last obstacle of a {@link KindNumber}, gone or not. */
  public int end(int kind) {
    int walled = walls == null ? 0 : Codes.WALLS;
    return kind == KindNumber.WALL ? walled : ofKind(kind).idLimit();
  }

  /** The codes of the live obstacles of a {@link KindNumber}; of an outline, of all its sides. */
  public IntStream codes(int kind) {
    return kind == KindNumber.WALL
        ? IntStream.range(0, end(kind)).filter(this::isWallThere)
        : ofKind(kind).present().stream(ofKind(kind)::isGone);
  }

  /** The ids of the live obstacles of a {@link KindNumber}, ascending. */
  public int[] ids(int kind) {
    return ids(codes(kind).toArray());
  }

  /** The ids of the obstacles to which ascending codes of one kind belong, each once. */
  public int[] ids(int... ascending) {
    return IntStream.of(ascending).map(this::id).distinct().toArray();
  }

  /** The id of the obstacle to which a code belongs. */
  public int id(int code) {
    return Codes.isWall(code) ? code : of(code).id(code);
  }

  /** The code of an id; of an outline, that of its first side. */
  public int code(int kind, int id) {
    return kind == KindNumber.WALL ? id : ofKind(kind).code(id);
  }

  /** The codes of the obstacle to which a code belongs: of an outline, of all its sides. */
  public IntStream codesOf(int code) {
    return IntStream.range(firstOf(code), endOf(code));
  }

  /** The first code of the obstacle to which a code belongs. */
  public int firstOf(int code) {
    return Codes.isWall(code) ? code : of(code).firstOf(code);
  }

  /** One more than the last code of the obstacle to which a code belongs. */
  public int endOf(int code) {
    return Codes.isWall(code) ? code + 1 : of(code).endOf(code);
  }

  /** Whether a code belongs to an outline of several sides. */
  public boolean isOutline(int code) {
    return endOf(code) - firstOf(code) > 1;
  }

  /** The number of a side within its outline; 0 of all else. */
  public int side(int code) {
    return code - firstOf(code);
  }

  /** Where the outside of a solid polygon is from its side: 1 left, -1 right; 0 of other things. */
  public int outside(int code) {
    return specials > 0 && Codes.isLine(code) ? ContactFlags.outside(traits(code)) : 0;
  }

  /** Whether a ray from a point to the left crosses a side, as it is at a time. */
  public boolean isCrossed(int side, double x, double y, double now) {
    double[] row = rowAt(side, now, 0);
    return Polygon.isCrossed(row[0], row[1], row[2], row[3], x, y);
  }

  /** Whether a point is inside of the solid polygon to which a side belongs, at a time. */
  public boolean isInside(int side, double x, double y, double now) {
    return outside(side) != 0
        && codesOf(side).filter(code -> isCrossed(code, x, y, now)).count() % 2 == 1;
  }

  /** The side of an outline that begins where another one ends; NONE if there is none. */
  public int nextSide(int code) {
    int next = code + 1;
    int end = endOf(code);
    return next < end ? next : outside(code) == 0 ? Index.NONE : firstOf(code);
  }

  /**
   * The code by which a feature of an obstacle is named: where a side of an outline ends, that of
   * the next side, which starts there. Scenes without outlines never come to that: then compilers
   * leave it out of the way of an impact, which is as large as they can inline.
   */
  public int named(int code, int feature) {
    int next = feature == Part.END && lines.areJoined() ? nextSide(code) : Index.NONE;
    return next == Index.NONE ? code : next;
  }

  /** The feature that {@link #named} means: the start of the next side for the end of one. */
  public int featureNamed(int code, int feature) {
    return named(code, feature) == code ? feature : Part.START;
  }

  /** The side of a solid polygon that shares an end with one of its sides. */
  public int neighbor(int code, boolean atStart) {
    return atStart && code != firstOf(code) ? code - 1 : atStart ? endOf(code) - 1 : nextSide(code);
  }

  /** The codes of all live obstacles. */
  public IntStream codes() {
    return IntStream.range(0, byKind.length).flatMap(this::codes);
  }

  /** The radius of an obstacle other than a wall around its spine. */
  public double radius(int code) {
    ObstacleRows rows = of(code);
    return rows.shape.radius(rows.values, rows.offset(code));
  }

  /** A copy of the row of an obstacle. */
  double[] row(int code) {
    return of(code).row(code);
  }

  /** Whether an obstacle other than a wall is there and never moved. */
  public boolean isStatic(int code) {
    return !isGone(code) && !moves(code);
  }

  // Moving obstacles.

  public ObstacleMotions motions() {
    return motions;
  }

  /** Sets the motions of obstacles that were just read or built. */
  public void setMotions(ObstacleMotions all) {
    motions = all;
  }

  /** Whether any obstacle moves, or moved before. */
  public boolean areMoving() {
    return motions.count() > 0;
  }

  /** Whether an obstacle moves, or moved before. */
  public boolean moves(int code) {
    return motions.count() > 0 && motions.indexOf(code) >= 0;
  }

  /** Whether an obstacle does not move now. */
  public boolean isAtRest(int code) {
    return ux(code) == 0 && uy(code) == 0 && !turns(code);
  }

  /** Whether an obstacle turns about a pivot; its velocity counts as 0 then. */
  public boolean turns(int code) {
    return motions.areTurning() && moves(code) && motions.turns(motions.indexOf(code));
  }

  /** Whether any obstacle turns. */
  public boolean areTurning() {
    return motions.areTurning();
  }

  public double pivotX(int code) {
    return motions.pivotX(motions.indexOf(code));
  }

  public double pivotY(int code) {
    return motions.pivotY(motions.indexOf(code));
  }

  /** The angular velocity of an obstacle that turns, at a time, given as head and tail. */
  public double rate(int code, double head, double tail) {
    return 2 * turnY(code, head, tail);
  }

  /**
   * The real part of q, of an obstacle that turns, seen from a time: see {@link ObstacleMotions}.
   */
  public double turnX(int code, double head, double tail) {
    return motions.turnX(motions.indexOf(code), epoch + head, tail);
  }

  /** The imaginary part of that q. */
  public double turnY(int code, double head, double tail) {
    return motions.turnY(motions.indexOf(code), epoch + head, tail);
  }

  /** The velocity that an obstacle has at a point (x, y) at a time, given as head and tail. */
  public double velocityX(int code, double y, double head, double tail) {
    return turns(code) ? -rate(code, head, tail) * (y - pivotY(code)) : ux(code);
  }

  public double velocityY(int code, double x, double head, double tail) {
    return turns(code) ? rate(code, head, tail) * (x - pivotX(code)) : uy(code);
  }

  /**
   * Sets moving obstacle i as what a flight meets: where it is as that starts, and how it goes on.
   *
   * @param i its number among those that move
   * @param head the time at which the flight starts, given as head and tail
   * @param row room for its numbers
   * @param flight the flight; it is returned
   */
  public Fall see(int i, double head, double tail, double[] row, Fall flight) {
    place(i, head, tail, row);
    flight.obstacle(of(motions.code(i)).shape, row, 0, motions.ux(i), motions.uy(i));
    return motions.turns(i)
        ? flight.turn(
            motions.pivotX(i),
            motions.pivotY(i),
            motions.turnX(i, epoch + head, tail),
            motions.turnY(i, epoch + head, tail))
        : flight;
  }

  public double ux(int code) {
    return moves(code) ? motions.ux(motions.indexOf(code)) : 0;
  }

  public double uy(int code) {
    return moves(code) ? motions.uy(motions.indexOf(code)) : 0;
  }

  /** The row of an obstacle other than a wall at a time, given as head and tail; a copy. */
  public double[] rowAt(int code, double head, double tail) {
    double[] row = row(code);
    if (moves(code)) {
      place(motions.indexOf(code), head, tail, row);
    }
    return row;
  }

  /**
   * Writes the numbers of a moving obstacle before its restitution at a time, given as head and
   * tail.
   *
   * @param i its number among those that move
   * @param row receives the numbers, in the order of its shape
   */
  public void place(int i, double head, double tail, double[] row) {
    int code = motions.code(i);
    ObstacleRows rows = of(code);
    int k = rows.offset(code);
    motions.place(i, epoch + head, tail, rows.values, k, row, 0, MOST_NUMBERS);
  }

  public double epoch() {
    return epoch;
  }

  /**
   * Begins a question, at a time of the world that counts as time 0 until the question ends. What
   * has arrived by then is at rest.
   */
  public void beginQuestion(double time) {
    endQuestion();
    epoch = time;
    for (int i = 0; i < motions.count(); i++) {
      if (motions.until(i) <= time) {
        restInQuestion(motions.code(i));
      }
    }
  }

  /** Lets an obstacle rest where it arrives, until the question ends. */
  public void restInQuestion(int code) {
    if (beforeQuestion == null) {
      beforeQuestion = motions;
      ofQuestions = motions.copyInto(ofQuestions);
      motions = ofQuestions;
    }
    motions = motions.with(code, 0, 0, epoch);
  }

  /** Ends a question; what it followed to its arrival moves on. */
  public void endQuestion() {
    epoch = 0;
    if (beforeQuestion != null) {
      motions = beforeQuestion;
      beforeQuestion = null;
    }
  }

  /** Gives an obstacle a velocity, from where it is at a given time. */
  public void setVelocity(int code, double ux, double uy, double now) {
    if (moves(code)) {
      of(code).advance(code, motions, now);
    } else if (ux == 0 && uy == 0) {
      return; // it is at rest, and never moved
    }
    motions = motions.with(code, ux, uy, now);
  }

  /**
   * Lets an obstacle move until it arrives, and then rest.
   *
   * @param numbers those before its restitution at its arrival
   * @param motion see {@link ObstacleMotions}
   */
  public void moveTo(int code, double[] numbers, double[] motion) {
    of(code).move(code, numbers);
    motions = motions.with(code, motion);
  }

  /** Whether an obstacle is on its way to a place, to arrive at a time, or rests there. */
  public boolean goesTo(int code, double x, double y, double arrival) {
    ObstacleRows rows = of(code);
    int k = rows.offset(code);
    boolean isMeant =
        rows.values[k + ObstacleShape.X] == x && rows.values[k + ObstacleShape.Y] == y;
    return isMeant && !turns(code) && (isAtRest(code) || arrival(code) == arrival);
  }

  /** Writes the numbers of an obstacle before its restitution at a time, as head and tail. */
  public void numbersAt(int code, double head, double tail, double[] to) {
    ObstacleRows rows = of(code);
    if (moves(code)) {
      place(motions.indexOf(code), head, tail, to);
    } else {
      System.arraycopy(rows.values, rows.offset(code), to, 0, rows.shape.restitution);
    }
  }

  /** The time of the next arrival of an obstacle; infinite if there is none. */
  public double nextArrival() {
    return motions.nextEnd() - epoch;
  }

  /** The time of arrival of an obstacle; infinite if it has none. */
  public double arrival(int code) {
    return moves(code) ? motions.until(motions.indexOf(code)) : Double.POSITIVE_INFINITY;
  }

  /** The {@link Part} of an obstacle that a contact code of the detector stands for. */
  public static int part(int code, int contact) {
    return Codes.isWall(code) ? Part.SIDE : Contact.part(contact);
  }

  /** The restitution along the normal; 0 for an obstacle at which circles halt. */
  public double restitution(int code) {
    return halts(code) ? 0 : givenRestitution(code);
  }

  /** The restitution as it was given, whatever the response. */
  public double givenRestitution(int code) {
    return Codes.isWall(code) ? boundsRestitution : of(code).restitution(code);
  }

  /** The {@link ContactFlags} of an obstacle. */
  public int traits(int code) {
    return Codes.isWall(code) ? boundsTraits : of(code).traits(code);
  }

  /** The {@link FilterBits} of an obstacle. */
  public long filter(int code) {
    return Codes.isWall(code) ? boundsFilter : of(code).filter(code);
  }

  /** Returns a predicate for the codes of the obstacles that a thing with a filter meets. */
  public IntPredicate met(long filter) {
    return code -> FilterBits.meet(filter, filter(code));
  }

  /** Whether any obstacle may have a filter other than the default. */
  public boolean areFiltered() {
    return filtered;
  }

  /** The walls that keep a circle of a given filter inside; null for none. */
  public double[] wallsFor(long filter) {
    return FilterBits.meet(boundsFilter, filter) ? walls : null;
  }

  /** Whether a circle that hits an obstacle halts. */
  public boolean halts(int code) {
    return (specials > 0 || Codes.isWall(code)) && ContactFlags.halts(traits(code));
  }

  /** Whether any obstacle but a wall has a trait. */
  public boolean areSpecial() {
    return specials > 0;
  }

  /** Whether any obstacle is a sensor. */
  public boolean haveSensors() {
    return sensors > 0;
  }

  public boolean isSensor(int code) {
    return specials > 0 && !Codes.isWall(code) && ContactFlags.isSensor(traits(code));
  }

  public boolean isOneWay(int code) {
    return specials > 0 && !Codes.isWall(code) && ContactFlags.isOneWay(traits(code));
  }

  /** The largest absolute coordinate of all obstacles but walls; 0 if there are none. */
  public double extent() {
    double extent = 0;
    for (int kind = 0; kind < kinds.size(); kind++) { // as in size()
      LiveCodes present = kinds.get(kind).present();
      for (int i = 0; i < present.size(); i++) {
        extent = Math.max(extent, extent(present.get(i)));
      }
    }
    return extent;
  }

  /** The largest absolute coordinate of an obstacle; 0 for one that was removed. */
  public double extent(int code) {
    return of(code).extent(code);
  }

  // Changes.

  /** Adds an elastic obstacle without traits, and returns its code. */
  public int add(int kind, double... numbers) {
    return ofKind(kind).add(numbers);
  }

  /** Adds an outline, elastic and without traits, and returns the code of its first side. */
  public int add(OutlinePoints outline) {
    int first = lines.end;
    for (int i = 0; i < outline.sides(); i++) {
      int code = add(KindNumber.LINE, outline.side(i));
      if (i > 0) {
        lines.joinLast();
      }
      setOutside(code, outline.outside());
    }
    return first;
  }

  /** The points of an outline, or of a line, as the rows say; its first code is given. */
  public OutlinePoints outline(int first) {
    double[][] rows = codesOf(first).mapToObj(this::row).toArray(double[][]::new);
    return OutlinePoints.of(rows, outside(first) != 0);
  }

  /** Sets where the outside of a solid polygon is from one of its sides; 0 of other things. */
  public void setOutside(int code, int outside) {
    setTraits(code, ContactFlags.withOutside(traits(code), outside));
  }

  /**
   * Sets the numbers of an obstacle before its restitution, at a given time. It moves on, unless it
   * was on its way to an arrival.
   */
  public void move(int code, double[] numbers, double now) {
    of(code).move(code, numbers);
    if (moves(code)) {
      boolean movesOn = arrival(code) == Double.POSITIVE_INFINITY;
      motions = motions.with(code, movesOn ? ux(code) : 0, movesOn ? uy(code) : 0, now);
    }
  }

  /** Removes an obstacle: no search finds it any more. */
  public void remove(int code) {
    of(code).remove(code);
    motions = motions.without(code);
    countSpecials();
  }

  public void setRestitution(int code, double e) {
    if (Codes.isWall(code)) {
      boundsRestitution = e;
    } else {
      of(code).setRestitution(code, e);
    }
  }

  /** Sets the {@link ContactFlags} of an obstacle. */
  public void setTraits(int code, int traits) {
    if (Codes.isWall(code)) {
      boundsTraits = traits;
    } else {
      of(code).setTraits(code, traits);
      countSpecials();
    }
  }

  /** Sets the {@link FilterBits} of an obstacle, that of a wall for all of them. */
  public void setFilter(int code, long filter) {
    if (Codes.isWall(code)) {
      boundsFilter = filter;
    } else {
      of(code).setFilter(code, filter);
    }
    countSpecials();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ObstacleTable that
        && Arrays.equals(walls, that.walls)
        && Double.compare(boundsRestitution, that.boundsRestitution) == 0
        && boundsTraits == that.boundsTraits
        && boundsFilter == that.boundsFilter
        && motions.equals(that.motions)
        && kinds.equals(that.kinds);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(walls) + kinds.hashCode();
  }
}
