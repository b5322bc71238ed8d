// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.zip.GZIPInputStream;

/** Files that appear as a whole or not at all, even if the process is ended while it writes. */
public final class WholeFile {

  private WholeFile() {}

  /**
   * Opens a file, or where it is not there its packed twin, {@code .gz} at the end of its name.
   *
   * @param file the file
   * @return its bytes, unpacked
   * @throws IOException if neither can be read; the message names the file
   */
  static InputStream open(Path file) throws IOException {
    Path packed = file.resolveSibling(file.getFileName() + ".gz");
    if (Files.exists(file) || !Files.exists(packed)) {
      return Files.newInputStream(file);
    }
    return new GZIPInputStream(Files.newInputStream(packed));
  }

  /**
   * Writes text in UTF-8.
   *
   * @param file where; one that is there is replaced
   * @param text all of it
   * @throws IOException if it cannot be written; the message names the file
   */
  public static void write(Path file, String text) throws IOException {
    write(file, text.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Writes bytes.
   *
   * @param file where; one that is there is replaced
   * @param bytes all of them
   * @throws IOException if it cannot be written; the message names the file
   */
  public static void write(Path file, byte[] bytes) throws IOException {
    Path draft = file.resolveSibling(file.getFileName() + ".draft");
    try {
      Files.write(draft, bytes);
      Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      throw new IOException(file + ": cannot be written", e);
    }
  }
}
