// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.ContactWord;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SavedFlights;
import dev.carom.internal.state.SizeLimits;
import dev.carom.internal.state.WorldState;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.DoubleList;
import dev.carom.internal.util.Kind;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.zip.CRC32;
import java.util.zip.CheckedInputStream;

/**
 * Reads and validates a snapshot. Besides the check sum, each number is checked against the values
 * that a world can hold.
 */
public final class SnapshotReader {

  private final CRC32 sum = new CRC32();
  private final DataInputStream in;

  /** How many obstacles of each {@link Kind} have codes. */
  private final int[] counts = new int[Kind.CIRCLE];

  /**
   * Codes of circles that were read before the list of circles was complete. They are checked at
   * the end.
   */
  private final IntStream.Builder codesOfCircles = IntStream.builder();

  /** Codes of obstacles that crushed a circle. They are checked when all that moves is known. */
  private final IntStream.Builder codesThatCrush = IntStream.builder();

  public SnapshotReader(InputStream in) {
    this.in = new DataInputStream(new CheckedInputStream(in, sum));
  }

  public WorldState read() throws IOException {
    try {
      return readWhole();
    } catch (EOFException e) {
      throw new IOException("snapshot is truncated: expected more bytes", e);
    } catch (IllegalArgumentException e) {
      throw corrupt(e.getMessage(), e);
    }
  }

  private WorldState readWhole() throws IOException {
    long mark = in.readLong();
    expect(mark == SnapshotWriter.MARK, "its first 8 bytes are not those of a snapshot");
    int version = in.readInt();
    expect(
        version == SnapshotWriter.VERSION,
        "its format version is "
            + version
            + ": expected "
            + SnapshotWriter.VERSION
            + ", the only one that this library reads");
    double now = in.readDouble();
    Check.notNegative("now", now);
    boolean collide = in.readBoolean();
    SizeLimits limits = limits();
    ObstacleTable obstacles = obstacles();
    WorldState state = circles(now, collide, obstacles, limits);
    state.flights().tailOfEdit = tailOfEdit(now);
    motions(now, obstacles);
    double gx = in.readDouble();
    double gy = in.readDouble();
    Check.finite("gx", gx);
    Check.finite("gy", gy);
    accelerations(state.flights(), obstacles);
    checkExtent(obstacles, limits);
    long expected = sum.getValue();
    expect(in.readLong() == expected, "its check sum differs from what it holds");
    return new WorldState(
        now, collide, obstacles, state.registry(), limits, state.flights(), gx, gy);
  }

  private void accelerations(SavedFlights flights, ObstacleTable obstacles) throws IOException {
    if (!in.readBoolean()) {
      return;
    }
    MovingCircle m = new MovingCircle();
    for (int i = 0; i < flights.count(); i++) {
      double gx = in.readDouble();
      double gy = in.readDouble();
      Check.finite("gx", gx);
      Check.finite("gy", gy);
      m.fall(gx, gy);
      m.setSupport(in.readInt());
      expectObstacle(m.support, obstacles);
      expectObstacle(m.leftLine, obstacles);
      expectCode(m.leftLine == MovingCircle.NOTHING || Codes.isLine(m.leftLine), m.leftLine);
      m.slowContacts = in.readInt();
      expect(
          m.slowContacts <= MovingCircle.SLOW_LIMIT,
          "the slow contacts of a circle are " + m.slowContacts);
      if (m.isFalling()) {
        flights.putAcceleration(i, m);
      }
    }
  }

  private void expectObstacle(int code, ObstacleTable obstacles) throws IOException {
    if (code != MovingCircle.NOTHING) {
      expectCode(!Codes.isCircle(code), code);
      checkCode(code);
      expectCode(Codes.isWall(code) ? obstacles.walls != null : !obstacles.isGone(code), code);
    }
  }

  private SizeLimits limits() throws IOException {
    double largest = in.readDouble();
    double least = in.readDouble();
    Check.notNegative("largest coordinate", largest);
    expect(
        SizeLimits.leastRadius(largest) <= least,
        "least radius is "
            + least
            + ": expected 2^10 ulps of the largest coordinate, "
            + largest
            + ", or more");
    return new SizeLimits(largest, least);
  }

  private ObstacleTable obstacles() throws IOException {
    counts[Kind.WALL] = Codes.WALLS;
    double[] walls = in.readBoolean() ? walls() : null;
    double restitution = in.readDouble();
    Check.notNegative("restitution", restitution);
    int traits = traits(1);
    long filter = in.readLong();
    ObstacleRows[] rows = new ObstacleRows[Kind.CIRCLE - Kind.LINE];
    for (int kind = Kind.LINE; kind < Kind.CIRCLE; kind++) {
      rows[kind - Kind.LINE] = rows(kind);
    }
    return ObstacleTable.of(walls, restitution, traits, filter, rows);
  }

  /** Refuses an obstacle beyond the largest coordinate; moving ones may be anywhere. */
  private static void checkExtent(ObstacleTable obstacles, SizeLimits limits) throws IOException {
    double extent =
        ObstacleTable.kindsOfRows()
            .flatMap(obstacles::codes)
            .filter(obstacles::isStatic)
            .mapToDouble(obstacles::extent)
            .max()
            .orElse(0);
    expect(
        extent <= limits.largest(),
        "coordinate is "
            + extent
            + ": expected at most the stored largest coordinate, "
            + limits.largest());
  }

  private void motions(double now, ObstacleTable obstacles) throws IOException {
    int count = count(obstacles.size());
    IntStream.Builder codes = IntStream.builder();
    DoubleList motions = new DoubleList();
    int least = Codes.line(0);
    for (int i = 0; i < count; i++) {
      int code = in.readInt();
      expectCode(code >= least && !Codes.isCircle(code), code);
      checkCode(code);
      expectCode(!obstacles.isGone(code), code);
      least = code + 1;
      double ux = in.readDouble();
      double uy = in.readDouble();
      Check.finite("vx", ux);
      Check.finite("vy", uy);
      double since = in.readDouble();
      expect(since >= 0 && since <= now, "an obstacle moves since " + since);
      codes.add(code);
      motions.add(ObstacleMotions.motion(ux, uy, since));
    }
    obstacles.setMotions(ObstacleMotions.of(codes.build().toArray(), motions.toArray()));
    for (int code : codesThatCrush.build().toArray()) {
      expectCode(obstacles.moves(code), code);
    }
  }

  private double[] walls() throws IOException {
    double xmin = in.readDouble();
    double ymin = in.readDouble();
    double xmax = in.readDouble();
    double ymax = in.readDouble();
    Check.bounds(xmin, ymin, xmax, ymax);
    return ObstacleTable.walls(xmin, ymin, xmax, ymax);
  }

  /**
   * Reads rows of finite numbers, each with a restitution at its end, and their traits. The row of
   * a removed obstacle is NaN.
   */
  private ObstacleRows rows(int kind) throws IOException {
    counts[kind] = count(Codes.limit(kind));
    DoubleList numbers = new DoubleList();
    ByteArrayOutputStream traits = new ByteArrayOutputStream();
    double[] row = new double[ObstacleTable.width(kind)];
    for (int i = 0; i < counts[kind]; i++) {
      int its = traitsOrGone(kind == Kind.LINE ? ContactFlags.MOST_OF_LINES : ContactFlags.MOST);
      if (its == SnapshotWriter.GONE) {
        Arrays.fill(row, Double.NaN);
        its = 0;
      } else {
        obstacle(kind, i, row);
      }
      numbers.add(row);
      traits.write(its);
    }
    long[] filters = filters(counts[kind]);
    return ObstacleTable.rows(kind, numbers.toArray(), traits.toByteArray(), filters);
  }

  /** Reads the filters of a kind; null if each is the default. */
  private long[] filters(int count) throws IOException {
    if (!in.readBoolean()) {
      return null;
    }
    LongStream.Builder filters = LongStream.builder();
    for (int i = 0; i < count; i++) {
      filters.add(in.readLong());
    }
    return filters.build().toArray();
  }

  private void obstacle(int kind, int i, double... row) throws IOException {
    for (int k = 0; k < row.length; k++) {
      row[k] = in.readDouble();
    }
    ObstacleTable.checkRow(kind, i, row);
  }

  private WorldState circles(
      double now, boolean collide, ObstacleTable obstacles, SizeLimits limits) throws IOException {
    int idLimit = in.readInt();
    expect(
        idLimit >= 0 && idLimit <= CircleRegistry.ID_LIMIT,
        "ids of circles end at " + idLimit + ": expected 0 to " + CircleRegistry.ID_LIMIT);
    int count = count(idLimit);
    IntStream.Builder ids = IntStream.builder();
    DoubleList masses = new DoubleList();
    ByteArrayOutputStream traits = new ByteArrayOutputStream();
    DoubleList numbers = new DoubleList();
    IntStream.Builder codes = IntStream.builder();
    List<IgnoreList> jams = new ArrayList<>();
    boolean lines = obstacles.lines.present().count() > 0;
    int least = 0;
    for (int i = 0; i < count; i++) {
      int id = in.readInt();
      expect(
          id >= least && id < idLimit,
          "circle id is " + id + ": expected " + least + " to " + (idLimit - 1) + ", ascending");
      least = id + 1;
      ids.add(id);
      traits.write(traits(3));
      masses.add(mass());
      flight(now, limits, lines, numbers, codes);
      jams.add(jam());
    }
    long[] filters = filters(count);
    int[] present = ids.build().toArray();
    for (int code : codesOfCircles.build().toArray()) {
      expectCode(Arrays.binarySearch(present, Codes.slot(code)) >= 0, code);
    }
    SavedFlights flights =
        new SavedFlights(
            present,
            numbers.toArray(),
            codes.build().toArray(),
            jams.stream().anyMatch(Objects::nonNull) ? jams.toArray(IgnoreList[]::new) : null);
    CircleRegistry registry =
        new CircleRegistry(masses.toArray(), traits.toByteArray(), filters, present, idLimit);
    return new WorldState(now, collide, obstacles, registry, limits, flights, 0, 0);
  }

  private double tailOfEdit(double now) throws IOException {
    double tail = in.readDouble();
    expect(tail >= 0 && tail <= Math.ulp(now), "the tail of the time of an edit is " + tail);
    return tail;
  }

  private double mass() throws IOException {
    double mass = in.readDouble();
    Check.mass("mass", mass);
    return mass;
  }

  private void flight(
      double now, SizeLimits limits, boolean lines, DoubleList numbers, IntStream.Builder codes)
      throws IOException {
    double[] n = new double[SavedFlights.NUMBERS];
    for (int k = 0; k < n.length; k++) {
      n[k] = in.readDouble();
      expect(!Double.isNaN(n[k]), "a number of a circle is NaN");
    }
    Check.finite("vx", n[FlightRow.VX]);
    Check.finite("vy", n[FlightRow.VY]);
    double start = n[FlightRow.T];
    expect(start >= 0 && start <= now, "a flight starts at " + start);
    double tail = n[FlightRow.TL];
    expect(Math.abs(tail) <= Math.ulp(start), "the tail of a time is " + tail);
    double radius = n[FlightRow.RADIUS] + 0.0; // 0 for -0
    n[FlightRow.RADIUS] = radius;
    Check.notNegative("radius", radius);
    expect(radius > 0 || !lines, "radius is " + radius + ": expected " + SizeLimits.NO_POINT);
    expect(
        radius == 0 || radius >= limits.least(),
        "radius is " + radius + ": expected at least " + limits.least());
    Check.notNegative("restitution", n[SavedFlights.RESTITUTION]);
    double sensed = n[SavedFlights.SENSED];
    expect(sensed >= 0, "a flight is known for " + sensed);
    numbers.add(n);
    int last = in.readInt();
    if (last != MovingCircle.NOTHING) {
      checkCode(last);
    }
    int stuck = in.readInt();
    expect(MovingCircle.isStuckWeight(stuck), "the weight of impacts at one place is " + stuck);
    int sensedCode = in.readInt();
    expect(sensedCode >= 0, "codes sensed end with " + sensedCode);
    int partner = in.readInt();
    expect(partner >= MovingCircle.NOTHING, "a partner is circle " + partner);
    codes.add(last).add(stuck).add(sensedCode).add(partner);
    int marks = in.readInt();
    expect(ContactWord.isValid(marks), "the marks of a circle are " + marks);
    codes.add(marks);
  }

  private IgnoreList jam() throws IOException {
    int count = count(Codes.limit(Kind.LINE));
    IntStream.Builder entries = IntStream.builder();
    for (int k = 0; k < count; k++) {
      int entry = in.readInt();
      int code = IgnoreList.code(entry);
      checkCode(code);
      if (IgnoreList.crushes(entry) && !Codes.isCircle(code)) {
        codesThatCrush.add(code);
      }
      entries.add(entry);
    }
    return IgnoreList.of(entries.build().distinct().toArray());
  }

  /**
   * Checks that a code exists. Codes of circles are collected and checked after all circles are
   * read.
   */
  private void checkCode(int code) throws IOException {
    if (Codes.isCircle(code)) {
      codesOfCircles.add(code);
    } else {
      expectCode(code >= 0 && Codes.index(code) < counts[Codes.kind(code)], code);
    }
  }

  private static void expectCode(boolean exists, int code) throws IOException {
    expect(exists, "code " + code + " does not exist");
  }

  private int count(int most) throws IOException {
    int count = in.readInt();
    expect(count >= 0 && count <= most, "count is " + count + ": expected 0 to " + most);
    return count;
  }

  private int traits(int most) throws IOException {
    int traits = traitsOrGone(most);
    expect(traits != SnapshotWriter.GONE, "traits are " + traits);
    return traits;
  }

  private int traitsOrGone(int most) throws IOException {
    int traits = in.readByte();
    boolean known = traits >= 0 && traits <= most && (traits & 3) != 3;
    expect(known || traits == SnapshotWriter.GONE, "traits are " + traits);
    return traits;
  }

  private static void expect(boolean good, String otherwise) throws IOException {
    if (!good) {
      throw corrupt(otherwise, null);
    }
  }

  private static IOException corrupt(String reason, Exception cause) {
    return new IOException("snapshot cannot be read: " + reason, cause);
  }
}
