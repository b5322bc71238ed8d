// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import java.io.IOException;
import java.io.InputStream;
import java.util.Properties;

/** The hashes that golden runs had when they were last stored: one a line, {@code run = hash}. */
public final class StoredHashes {

  private static final String RESOURCE = "/dev/carom/bench/hashes.properties";

  private final Properties hashes = new Properties();

  private StoredHashes() {}

  /**
   * Reads those of this version.
   *
   * @throws IOException if the resource cannot be read
   */
  public static StoredHashes read() throws IOException {
    StoredHashes stored = new StoredHashes();
    try (InputStream in = StoredHashes.class.getResourceAsStream(RESOURCE)) {
      stored.hashes.load(in);
    }
    return stored;
  }

  /**
   * That of a run.
   *
   * @param label what the run is called
   * @return 64 hexadecimal digits; none if no hash is stored
   */
  public String of(String label) {
    return hashes.getProperty(label, "");
  }
}
