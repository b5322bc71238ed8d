// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.util.concurrent.ThreadLocalRandom;
import java.util.zip.GZIPInputStream;

/**
 * A file that appears as a whole or not at all: bytes go to a draft beside it, which {@link
 * #commit} puts in its place and {@link #close} without it throws away. Symbolic links stay, and
 * who may read the file stays the same. A pipe or a device has no draft. All that fails names the
 * file and the cause.
 */
public final class WholeFile implements AutoCloseable {

  /** As many as Linux follows. */
  private static final int MOST_LINKS = 40;

  private final Path file;
  private final Path target;
  private final Path draft;
  private final OutputStream out;

  private WholeFile(Path file) throws IOException {
    this.file = file;
    try {
      target = target(file);
      draft = isSpecial(file) ? target : createDraft(target);
    } catch (IOException e) {
      throw cannotBeWritten(e);
    }
    out = open();
  }

  /**
   * Begins to write a file.
   *
   * @param file where; one that is there is replaced at the end
   * @return the file, to be {@linkplain #commit committed} and closed
   * @throws IOException if it cannot be written; the message names the file
   */
  public static WholeFile create(Path file) throws IOException {
    return new WholeFile(file);
  }

  /**
   * Writes text in UTF-8.
   *
   * @param file where; one that is there is replaced
   * @throws IOException if it cannot be written; the message names the file
   */
  public static void write(Path file, String text) throws IOException {
    write(file, text.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Writes bytes.
   *
   * @param file where; one that is there is replaced
   * @throws IOException if it cannot be written; the message names the file
   */
  public static void write(Path file, byte[] bytes) throws IOException {
    try (WholeFile whole = create(file)) {
      whole.out().write(bytes);
      whole.commit();
    }
  }

  /**
   * Opens a file, or where it is not there its packed twin, {@code .gz} at the end of its name.
   *
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
   * The file that symbolic links lead to, also where it is not there yet.
   *
   * @return the path itself if it is no link
   * @throws IOException if a link cannot be read, or leads to itself
   */
  public static Path target(Path file) throws IOException {
    Path target = file;
    for (int links = 0; Files.isSymbolicLink(target); links++) {
      if (links == MOST_LINKS) {
        throw new FileSystemLoopException(file.toString());
      }
      target = target.resolveSibling(Files.readSymbolicLink(target));
    }
    return target;
  }

  /**
   * Whether a path is that of a pipe or a device, which is written to as it is: false where nothing
   * is.
   */
  public static boolean isSpecial(Path file) {
    return Files.exists(file) && !Files.isRegularFile(file);
  }

  /** A file of a name that none has, and that has room wherever the name of the target has. */
  private static Path createDraft(Path target) throws IOException {
    String random = Long.toHexString(ThreadLocalRandom.current().nextLong());
    Path draft = Files.createFile(target.resolveSibling("carom-" + random + ".tmp"));
    draft.toFile().deleteOnExit(); // if the process is ended
    return draft;
  }

  private OutputStream open() throws IOException {
    try {
      keepAccess();
      return new Named(Files.newOutputStream(draft, StandardOpenOption.WRITE));
    } catch (IOException e) {
      deleteDraft();
      throw cannotBeWritten(e);
    }
  }

  private void keepAccess() throws IOException {
    PosixFileAttributeView view = Files.getFileAttributeView(target, PosixFileAttributeView.class);
    if (!draft.equals(target) && Files.exists(target) && view != null) {
      Files.setPosixFilePermissions(draft, view.readAttributes().permissions());
    }
  }

  private void deleteDraft() throws IOException {
    if (!draft.equals(target)) {
      Files.deleteIfExists(draft);
    }
  }

  /** Where to write: a stream without a buffer. */
  public OutputStream out() {
    return out;
  }

  /**
   * Puts what was written in the place of the file.
   *
   * @throws IOException if that fails; the message names the file
   */
  public void commit() throws IOException {
    out.close();
    if (!draft.equals(target)) {
      try {
        Files.move(
            draft, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
      } catch (IOException e) {
        throw cannotBeWritten(e);
      }
    }
  }

  @Override
  public void close() throws IOException {
    try {
      out.close();
    } finally {
      deleteDraft();
    }
  }

  private IOException cannotBeWritten(IOException cause) {
    return new IOException(file + ": cannot be written: " + reason(cause), cause);
  }

  /** The reason, without the name of a file. */
  private static String reason(IOException e) {
    if (e instanceof NoSuchFileException) {
      return "no such folder";
    }
    if (e instanceof AccessDeniedException) {
      return "access denied";
    }
    if (e instanceof FileSystemLoopException) {
      return "more than 40 symbolic links in a row (a loop?)";
    }
    return e instanceof FileSystemException known ? known.getReason() : e.getMessage();
  }

  /** Tells by which file a failure came. */
  private final class Named extends FilterOutputStream {

    Named(OutputStream out) {
      super(out);
    }

    @Override
    public void write(int b) throws IOException {
      write(new byte[] {(byte) b}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int from, int length) throws IOException {
      try {
        out.write(bytes, from, length);
      } catch (IOException e) {
        throw cannotBeWritten(e);
      }
    }

    @Override
    public void close() throws IOException {
      try {
        out.close();
      } catch (IOException e) {
        throw cannotBeWritten(e);
      }
    }
  }
}
