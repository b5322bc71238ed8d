// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import dev.carom.Snapshot;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;

/** Snapshots as bytes. */
public final class SnapshotBytes {

  private SnapshotBytes() {}

  /** A snapshot, written. */
  public static byte[] of(Snapshot snapshot) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try {
      snapshot.write(out);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toByteArray();
  }
}
