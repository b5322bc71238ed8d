// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.SceneData;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.Writer;
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

/** Reads and writes scene files. The format is documented at {@code Scene}. */
public final class SceneFile {

  /** The longest chain of symbolic links that is followed: the limit of Linux. */
  private static final int MOST_LINKS = 40;

  private SceneFile() {}

  public static SceneData read(Path path) throws IOException {
    expectFile(path);
    // Not Files.newBufferedReader: its decoder throws at a comment that is not UTF-8.
    try (Reader in = new InputStreamReader(Files.newInputStream(path), StandardCharsets.UTF_8)) {
      return read(in);
    }
  }

  public static SceneData read(Reader in) throws IOException {
    return new SceneReader().read(in);
  }

  public static void write(SceneData scene, Path path) throws IOException {
    expectFile(path);
    try {
      if (Files.exists(path) && !Files.isRegularFile(path)) {
        writeDirectly(scene, path); // a pipe or a device cannot be replaced by a file
      } else {
        replace(scene, target(path));
      }
    } catch (IOException e) { // its message names the temporary file, or no file
      throw cannotBeWritten(path, e);
    }
  }

  private static void expectFile(Path path) throws IOException {
    if (Files.isDirectory(path)) {
      throw new FileSystemException(path.toString(), null, "is a folder: expected a file");
    }
  }

  /** The file at the end of the symbolic links, whether or not it exists. */
  private static Path target(Path path) throws IOException {
    Path target = path;
    for (int links = 0; Files.isSymbolicLink(target); links++) {
      if (links == MOST_LINKS) {
        throw new FileSystemLoopException(path.toString());
      }
      target = target.resolveSibling(Files.readSymbolicLink(target));
    }
    return target;
  }

  /**
   * Writes a temporary file beside the target and renames it. Its name is short, so that it fits
   * wherever the target's name does.
   */
  private static void replace(SceneData scene, Path target) throws IOException {
    String random = Long.toHexString(ThreadLocalRandom.current().nextLong());
    Path draft = Files.createFile(target.resolveSibling("carom-" + random + ".tmp"));
    try {
      keepAccess(target, draft);
      writeDirectly(scene, draft);
      Files.move(
          draft, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(draft);
    }
  }

  /** Gives the replacement the permissions of the file that it replaces. */
  private static void keepAccess(Path target, Path draft) throws IOException {
    PosixFileAttributeView view = Files.getFileAttributeView(target, PosixFileAttributeView.class);
    if (Files.exists(target) && view != null) {
      Files.setPosixFilePermissions(draft, view.readAttributes().permissions());
    }
  }

  private static IOException cannotBeWritten(Path path, IOException cause) {
    String reason = "cannot be written: " + reason(cause);
    IOException e = new FileSystemException(path.toString(), null, reason);
    e.initCause(cause);
    return e;
  }

  /** The reason without the name of a file. */
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

  private static void writeDirectly(SceneData scene, Path path) throws IOException {
    try (Writer out = Files.newBufferedWriter(path, StandardOpenOption.WRITE)) {
      write(scene, out);
    }
  }

  public static void write(SceneData scene, Appendable out) throws IOException {
    new SceneWriter(out).write(scene);
  }
}
