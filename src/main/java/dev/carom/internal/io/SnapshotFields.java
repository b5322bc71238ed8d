// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactRow;
import dev.carom.internal.state.FlightTable;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.SceneDataBuilder;
import dev.carom.internal.state.SizeLimits;
import dev.carom.internal.state.WorldState;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.KindNumber;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * The fields of a snapshot in their order: the one list that both the writer and the reader follow.
 * Each method takes a part of a state, passes its fields to a {@link FieldStream}, and makes the
 * same part of the fields that the stream returns.
 */
final class SnapshotFields {

  /** A state without anything, which gives no fields to a stream that reads. */
  static final WorldState NONE = none();

  /** Stands for the traits of a removed obstacle. Nothing else of it is in the stream. */
  private static final int GONE = -1;

  /** "CAROM" and a zero byte, which no text contains. */
  private static final long MARK = 0x4341524F4D00L;

  private static final int VERSION = 14;

  private final FieldStream f;

  SnapshotFields(FieldStream stream) {
    f = stream;
  }

  private static WorldState none() {
    SceneData scene = new SceneDataBuilder().build();
    return new WorldState(
        0,
        false,
        scene.obstacles,
        new CircleRegistry(scene, 0),
        new SizeLimits(),
        new FlightTable(0),
        0,
        0,
        0);
  }

  WorldState all(WorldState s) throws IOException {
    long mark = f.bits(MARK);
    SnapshotChecks.expect(mark == MARK, "its first 8 bytes are not those of a snapshot: ", mark);
    int version = f.integer(VERSION);
    if (version != VERSION) {
      String only = VERSION + ", the only one that this library reads";
      throw Check.refused("its format version", version, only);
    }
    double now = f.number(s.now());
    boolean collide = f.flag(s.collide());
    double largest = f.number(s.limits().largest());
    double least = f.number(s.limits().least());
    ObstacleTable obstacles = obstacles(s.obstacles());
    CircleRegistry circles = circles(s.registry());
    FlightTable flights = flights(s.flights(), circles.count());
    double tailOfEdit = f.number(s.tailOfEdit());
    double gx = f.number(s.gx());
    double gy = f.number(s.gy());
    SizeLimits limits = new SizeLimits(largest, least);
    return new WorldState(now, collide, obstacles, circles, limits, flights, tailOfEdit, gx, gy);
  }

  private ObstacleTable obstacles(ObstacleTable given) throws IOException {
    boolean bounded = f.flag(given.walls != null);
    double[] walls = bounded ? f.numbers(given.walls, 1, Codes.WALLS) : null;
    ObstacleTable obstacles = ObstacleTable.empty(walls);
    obstacles.setRestitution(Codes.LEFT, f.number(given.boundsRestitution));
    obstacles.setTraits(Codes.LEFT, f.octet(given.boundsTraits));
    obstacles.setFilter(Codes.LEFT, f.bits(given.filter(Codes.LEFT)));
    for (ObstacleRows rows : given.kinds) {
      rows(rows, obstacles);
    }
    obstacles.setMotions(motions(given.motions(), obstacles.size()));
    return obstacles;
  }

  private void rows(ObstacleRows given, ObstacleTable obstacles) throws IOException {
    int kind = given.kind();
    int count = f.count(given.count(), Codes.limit(kind));
    double[] none = new double[ObstacleTable.width(kind)];
    for (int i = 0; i < count; i++) {
      int code = given.first() + i;
      boolean isGiven = i < given.count() && !given.isGone(code);
      int traits = f.octet(isGiven ? given.traits(code) : GONE);
      if (traits == GONE) {
        obstacles.remove(obstacles.add(kind, none));
      } else {
        double[] row = f.numbers(isGiven ? given.row(code) : none, 1, none.length);
        ObstacleTable.checkRow(kind, i, row);
        obstacles.add(kind, row);
        obstacles.setRestitution(code, row[row.length - 1]);
        obstacles.setTraits(code, traits);
      }
    }
    filters(given.filters(), count, (i, filter) -> obstacles.setFilter(given.first() + i, filter));
    if (kind == KindNumber.LINE) {
      int[] joined = f.integers(given.joined(), f.count(given.joined().length, count), 1);
      SnapshotChecks.joined(joined, count);
      obstacles.lines.join(joined);
    }
  }

  private ObstacleMotions motions(ObstacleMotions given, int most) throws IOException {
    int count = f.count(given.count(), most);
    int[] codes = f.integers(given.codes(), count, 1);
    return ObstacleMotions.of(codes, f.numbers(given.motions(), count, ObstacleMotions.SIZE));
  }

  private CircleRegistry circles(CircleRegistry given) throws IOException {
    int idLimit = f.count(given.idLimit(), CircleRegistry.ID_LIMIT);
    int count = f.count(given.count(), idLimit);
    int[] ids = f.integers(given.ids(), count, 1);
    SnapshotChecks.ids(ids, idLimit);
    CircleRegistry circles = new CircleRegistry(ids, idLimit);
    for (int i = 0; i < count; i++) {
      boolean isGiven = i < given.count();
      circles.setTraits(i, f.octet(isGiven ? given.traits(i) : 0));
      circles.setMass(i, f.number(isGiven ? given.mass(i) : 0));
    }
    filters(given.filters(), count, circles::setFilter);
    return circles;
  }

  /** All columns; of those that no circle needs, only that they are missing. */
  private FlightTable flights(FlightTable given, int count) throws IOException {
    double[][] numbers = given.numbers();
    for (int k = 0; k < numbers.length; k++) {
      boolean there = k == 0 || f.flag(numbers[k] != null);
      numbers[k] = there ? f.numbers(numbers[k], count, FlightTable.width(k)) : null;
    }
    int[] codes = f.integers(given.codes, count, FlightTable.CODES);
    IgnoreList[] jams = jams(given.jams, count);
    return new FlightTable(numbers, codes, jams, contacts(given.contactRows, count));
  }

  /** The contact of all members, or only that there is none. */
  private double[][] contacts(double[][] given, int count) throws IOException {
    if (!f.flag(given != null)) {
      return null;
    }
    List<double[]> rows = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double[] row = given == null || given[i] == null ? new double[0] : given[i];
      int size = f.count(row.length, ContactRow.MOST);
      rows.add(size == 0 ? null : f.numbers(row, 1, size));
    }
    return rows.toArray(double[][]::new);
  }

  /** The ignore lists of all circles, or only that no circle is jammed. */
  private IgnoreList[] jams(IgnoreList[] given, int count) throws IOException {
    if (!f.flag(given != null)) {
      return null;
    }
    List<IgnoreList> jams = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      int[] entries = given == null || given[i] == null ? new int[0] : given[i].entries();
      int size = f.count(entries.length, Codes.limit(KindNumber.LINE));
      jams.add(IgnoreList.of(f.integers(entries, size, 1)));
    }
    return jams.toArray(IgnoreList[]::new);
  }

  /** Sets the filters of a kind of things, or takes only that each is the default. */
  private void filters(long[] given, int count, FilterSetter setter) throws IOException {
    if (f.flag(given != null)) {
      for (int i = 0; i < count; i++) {
        setter.set(i, f.bits(given == null ? 0 : given[i]));
      }
    }
  }

  /** Sets the filter of a thing, by its number within its kind. */
  private interface FilterSetter {
    void set(int i, long filter);
  }
}
