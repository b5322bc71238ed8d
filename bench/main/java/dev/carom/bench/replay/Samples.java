// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The measurements of one fork. Only the process that started the fork reads its file. */
public final class Samples {

  private final long[] cold;
  private final List<long[]> replays;
  private final long emptyPairNanos;
  private final long bytesAllocated;

  Samples(long[] cold, List<long[]> replays, long emptyPairNanos, long bytesAllocated) {
    this.cold = cold;
    this.replays = replays;
    this.emptyPairNanos = emptyPairNanos;
    this.bytesAllocated = bytesAllocated;
  }

  /** The frame times, in ns, of the first replay of the fresh virtual machine. */
  long[] cold() {
    return cold;
  }

  /** The frame times of each replay after the warm-up: in nanoseconds. */
  public List<long[]> replays() {
    return replays;
  }

  /** The cost of the two time stamps that each frame time includes. */
  long emptyPairNanos() {
    return emptyPairNanos;
  }

  /** Returns the memory that one replay after the warm-up allocates. */
  public long bytesAllocated() {
    return bytesAllocated;
  }

  void write(Path file) throws IOException {
    try (var out = new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(file)))) {
      writeTimes(out, cold);
      out.writeInt(replays.size());
      for (long[] replay : replays) {
        writeTimes(out, replay);
      }
      out.writeLong(emptyPairNanos);
      out.writeLong(bytesAllocated);
    }
  }

  static Samples read(Path file) throws IOException {
    try (var in = new DataInputStream(new BufferedInputStream(Files.newInputStream(file)))) {
      long[] cold = readTimes(in);
      List<long[]> replays = new ArrayList<>();
      for (int left = in.readInt(); left > 0; left--) {
        replays.add(readTimes(in));
      }
      return new Samples(cold, replays, in.readLong(), in.readLong());
    }
  }

  private static void writeTimes(DataOutputStream out, long[] nanos) throws IOException {
    out.writeInt(nanos.length);
    for (long time : nanos) {
      out.writeLong(time);
    }
  }

  private static long[] readTimes(DataInputStream in) throws IOException {
    long[] nanos = new long[in.readInt()];
    for (int i = 0; i < nanos.length; i++) {
      nanos[i] = in.readLong();
    }
    return nanos;
  }
}
