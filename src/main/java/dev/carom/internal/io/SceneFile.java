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

/** Scenes in files: see {@code Scene} for the format. */
public final class SceneFile {

  /** As many as Linux follows. */
  private static final int MOST_LINKS = 40;

  private SceneFile() {}

  public static SceneData read(Path path) throws IOException {
    expectFile(path);
    // A reader of its own, since those of Files stop at a comment that is not UTF-8.
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
        writeDirectly(scene, path); // a pipe or a device: no file to spare
      } else {
        replace(scene, target(path));
      }
    } catch (IOException e) { // which names a draft, or nothing
      throw cannotBeWritten(path, e);
    }
  }

  private static void expectFile(Path path) throws IOException {
    if (Files.isDirectory(path)) {
      throw new FileSystemException(path.toString(), null, "is a folder: expected a file");
    }
  }

  /** The file that symbolic links lead to, also where it is not there yet. */
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

  /** Its name is short, so that it fits wherever that of the target does. */
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

  /** Who may read a file that is there may read what replaces it, and no one else. */
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

  /** What happened, without the name of a file. */
  private static String reason(IOException e) {
    if (e instanceof NoSuchFileException) {
      return "no such folder";
    }
    if (e instanceof AccessDeniedException) {
      return "access denied";
    }
    if (e instanceof FileSystemLoopException) {
      return "its symbolic links lead to no file";
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
