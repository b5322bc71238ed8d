// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.WorldState;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.zip.CRC32;
import java.util.zip.CheckedInputStream;
import java.util.zip.CheckedOutputStream;

/** Reads and writes snapshots: the {@link SnapshotFields}, and a check sum of all their bytes. */
public final class SnapshotFile {

  private SnapshotFile() {}

  public static void write(WorldState state, OutputStream out) throws IOException {
    CRC32 sum = new CRC32();
    DataOutputStream data = new DataOutputStream(new CheckedOutputStream(out, sum));
    new SnapshotFields(new FieldStream(null, data)).all(state);
    data.writeLong(sum.getValue());
  }

  /** Besides the check sum, each number is checked against the values that a world can hold. */
  public static WorldState read(InputStream in) throws IOException {
    CRC32 sum = new CRC32();
    DataInputStream data = new DataInputStream(new CheckedInputStream(in, sum));
    try {
      WorldState state = new SnapshotFields(new FieldStream(data, null)).all(SnapshotFields.NONE);
      long expected = sum.getValue();
      SnapshotChecks.expect(
          data.readLong() == expected, "its check sum differs from what it holds: ", expected);
      new SnapshotChecks(state).all();
      return state;
    } catch (EOFException e) {
      throw new IOException("snapshot is truncated: expected more bytes", e);
    } catch (IllegalArgumentException e) {
      throw new IOException("snapshot cannot be read: " + e.getMessage(), e);
    }
  }
}
