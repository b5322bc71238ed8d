// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SavedFlights;
import dev.carom.internal.state.WorldState;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.zip.CRC32;
import java.util.zip.CheckedOutputStream;

/**
 * Writes a snapshot: a magic number, a version, the numbers in a fixed order, and a check sum of
 * all that precedes it.
 */
public final class SnapshotWriter {

  /** "CAROM" and a zero byte, which no text contains. */
  static final long MARK = 0x4341524F4D00L;

  static final int VERSION = 7;

  /**
   * Marks a removed obstacle: this byte stands for its traits, and nothing else of it is written.
   */
  static final int GONE = -1;

  private final CRC32 sum = new CRC32();
  private final DataOutputStream out;

  public SnapshotWriter(OutputStream out) {
    this.out = new DataOutputStream(new CheckedOutputStream(out, sum));
  }

  public void write(WorldState s) throws IOException {
    out.writeLong(MARK);
    out.writeInt(VERSION);
    out.writeDouble(s.now());
    out.writeBoolean(s.collide());
    out.writeDouble(s.limits().largest());
    out.writeDouble(s.limits().least());
    bounds(s.obstacles());
    for (ObstacleRows rows : s.obstacles().kinds) {
      obstacles(rows);
    }
    circles(s);
    out.writeDouble(s.flights().tailOfEdit);
    motions(s.obstacles().motions());
    gravity(s);
    out.writeLong(sum.getValue());
  }

  private void bounds(ObstacleTable o) throws IOException {
    double[] w = o.walls;
    out.writeBoolean(w != null);
    if (w != null) {
      numbers(w[Codes.LEFT], w[Codes.BOTTOM], w[Codes.RIGHT], w[Codes.TOP]);
    }
    out.writeDouble(o.boundsRestitution);
    out.writeByte(o.boundsTraits);
    out.writeLong(o.filter(Codes.LEFT));
  }

  private void obstacles(ObstacleRows rows) throws IOException {
    out.writeInt(rows.count());
    for (int code = rows.first(); code < rows.end; code++) {
      obstacle(rows, code);
    }
    filters(rows.filters());
  }

  /** Writes one filter for each thing of a kind; of nothing but defaults, only that it is so. */
  private void filters(long[] filters) throws IOException {
    out.writeBoolean(filters != null);
    for (int i = 0; filters != null && i < filters.length; i++) {
      out.writeLong(filters[i]);
    }
  }

  private void motions(ObstacleMotions motions) throws IOException {
    out.writeInt(motions.count());
    for (int i = 0; i < motions.count(); i++) {
      out.writeInt(motions.code(i));
      numbers(motions.ux(i), motions.uy(i), motions.since(i));
    }
  }

  /** Writes gravity, then what moves each circle; where nothing does, only that it is so. */
  private void gravity(WorldState s) throws IOException {
    numbers(s.gx(), s.gy());
    out.writeBoolean(s.flights().haveAccelerations());
    MovingCircle m = new MovingCircle();
    for (int i = 0; s.flights().haveAccelerations() && i < s.flights().count(); i++) {
      s.flights().get(i, m);
      numbers(m.gx, m.gy);
      out.writeInt(m.supportWord());
      out.writeInt(m.slowContacts);
    }
  }

  private void obstacle(ObstacleRows rows, int code) throws IOException {
    if (rows.isGone(code)) {
      out.writeByte(GONE);
      return;
    }
    out.writeByte(rows.traits(code));
    numbers(rows.row(code));
  }

  private void circles(WorldState s) throws IOException {
    out.writeInt(s.registry().idLimit());
    out.writeInt(s.registry().count());
    for (int i = 0; i < s.registry().count(); i++) { // the slots of a snapshot are dense
      out.writeInt(s.registry().id(i));
      out.writeByte(s.registry().traits(i));
      out.writeDouble(s.registry().mass(i));
      flight(s.flights(), i);
    }
    filters(s.registry().filters());
  }

  private void flight(SavedFlights flights, int k) throws IOException {
    for (int i = 0; i < SavedFlights.NUMBERS; i++) {
      out.writeDouble(flights.numbers[k * SavedFlights.NUMBERS + i]);
    }
    for (int i = 0; i < SavedFlights.CODES; i++) {
      out.writeInt(flights.codes[k * SavedFlights.CODES + i]);
    }
    jam(flights.jams == null ? null : flights.jams[k]);
  }

  private void jam(IgnoreList jam) throws IOException {
    int[] codes = jam == null ? new int[0] : jam.entries();
    out.writeInt(codes.length);
    for (int code : codes) {
      out.writeInt(code);
    }
  }

  private void numbers(double... numbers) throws IOException {
    for (double number : numbers) {
      out.writeDouble(number);
    }
  }
}
