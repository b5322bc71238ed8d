// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.zip.CRC32;
import java.util.zip.CheckedOutputStream;

/** Writes a snapshot: a mark, a version, its numbers in one order, and a check sum of all that. */
final class SnapshotWriter {

  /** "CAROM" and a byte that text does not hold. */
  static final long MARK = 0x4341524F4D00L;

  static final int VERSION = 1;

  private final CRC32 sum = new CRC32();
  private final DataOutputStream out;

  SnapshotWriter(OutputStream out) {
    this.out = new DataOutputStream(new CheckedOutputStream(out, sum));
  }

  void write(Snapshot s) throws IOException {
    out.writeLong(MARK);
    out.writeInt(VERSION);
    out.writeDouble(s.now);
    out.writeBoolean(s.collide);
    out.writeDouble(s.limits.largest());
    out.writeDouble(s.limits.least());
    bounds(s.obstacles);
    obstacles(s.obstacles);
    circles(s);
    out.writeLong(sum.getValue());
  }

  private void bounds(Obstacles o) throws IOException {
    out.writeBoolean(o.bounds != null);
    if (o.bounds != null) {
      numbers(o.bounds.xmin(), o.bounds.ymin(), o.bounds.xmax(), o.bounds.ymax());
    }
    out.writeDouble(o.boundsRestitution);
    out.writeByte(o.boundsTraits);
  }

  private void obstacles(Obstacles o) throws IOException {
    out.writeInt(o.endOfLines - Obstacles.WALLS);
    for (int code = Obstacles.WALLS; code < o.endOfLines; code++) {
      for (int i = 0; i < Scene.LINE; i++) {
        out.writeDouble(o.lines[o.offset(code) + i]);
      }
      out.writeByte(o.traits(code));
    }
    out.writeInt(o.endOfPegs - Obstacles.PEGS);
    for (int code = Obstacles.PEGS; code < o.endOfPegs; code++) {
      for (int i = 0; i < Scene.PEG; i++) {
        out.writeDouble(o.pegs[o.offset(code) + i]);
      }
      out.writeByte(o.traits(code));
    }
  }

  private void circles(Snapshot s) throws IOException {
    int count = s.flights.count();
    out.writeInt(count);
    for (int i = 0; i < count; i++) {
      out.writeBoolean(s.roster.contains(i));
      out.writeDouble(s.roster.mass(i));
      out.writeByte(s.roster.traits(i));
      for (int k = 0; k < FlightStates.NUMBERS; k++) {
        out.writeDouble(s.flights.numbers[i * FlightStates.NUMBERS + k]);
      }
      for (int k = 0; k < FlightStates.CODES; k++) {
        out.writeInt(s.flights.codes[i * FlightStates.CODES + k]);
      }
      jam(s.flights.jams == null ? null : s.flights.jams[i]);
    }
  }

  private void jam(Jam jam) throws IOException {
    int[] codes = jam == null ? new int[0] : jam.codes();
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
