// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.util.concurrent.ThreadLocalRandom;

/** Scenes in files: see {@link Scene} for the format. */
final class SceneFile {

  private SceneFile() {}

  static Scene read(Path path) throws IOException {
    if (Files.isDirectory(path)) {
      throw new FileSystemException(path.toString(), null, "is a folder: expected a file");
    }
    // A reader of its own, since those of Files stop at a comment that is not UTF-8.
    try (Reader in = new InputStreamReader(Files.newInputStream(path), StandardCharsets.UTF_8)) {
      return read(in, path.toString());
    }
  }

  static Scene read(Reader in, String name) throws IOException {
    return new SceneReader(name).read(in);
  }

  static void write(Scene scene, Path path) throws IOException {
    if (Files.exists(path) && !Files.isRegularFile(path)) {
      writeDirectly(scene, path, StandardOpenOption.WRITE); // a pipe or a device: no file to spare
      return;
    }
    Path target = Files.exists(path) ? path.toRealPath() : path;
    String random = Long.toHexString(ThreadLocalRandom.current().nextLong());
    Path draft = target.resolveSibling(target.getFileName() + "." + random + ".tmp");
    try {
      Files.createFile(draft);
      keepAccess(target, draft);
      writeDirectly(scene, draft, StandardOpenOption.WRITE);
      Files.move(
          draft, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } catch (FileSystemException e) {
      throw cannotBeWritten(path, e); // which names the draft
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
    IOException e = new FileSystemException(path.toString(), null, "cannot be written");
    e.initCause(cause);
    return e;
  }

  private static void writeDirectly(Scene scene, Path path, StandardOpenOption... options)
      throws IOException {
    try (Writer out = Files.newBufferedWriter(path, options)) {
      write(scene, out);
    }
  }

  static void write(Scene scene, Appendable out) throws IOException {
    new SceneWriter(out).write(scene);
  }
}
