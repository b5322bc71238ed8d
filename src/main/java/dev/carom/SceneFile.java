// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.ThreadLocalRandom;

/**
 * Scenes as text, in UTF-8: one thing a row, its fields separated by commas.
 *
 * <pre>
 * # xmin, ymin, xmax, ymax
 * wall,0,0,800,600
 * # ax, ay, bx, by
 * line,300,200,500,400,restitution=0.9
 * # x, y, radius
 * peg,600,300,25
 * # x, y, radius, vx, vy and, if need be, the mass
 * circle,100,100,10,4,3
 * </pre>
 *
 * <ul>
 *   <li>Things of one kind are numbered from 0 in the order of their rows; the kinds may be mixed.
 *   <li>A number is decimal or a hex float ({@code 0x1.8p-3}), read to the nearest double. NaN,
 *       infinities and numbers beyond the range of a double are refused.
 *   <li>{@code wall} is the {@linkplain Bounds bounds}; there is at most one such row.
 *   <li>The mass of a circle is 1 if not given; {@code inf} or {@code Infinity} stand for an
 *       infinite one. It has no effect as long as circles ignore each other.
 *   <li>{@code collide,1} says that circles collide with each other; with {@code collide,0}, or
 *       without such a row, they ignore each other.
 *   <li>Any row but {@code collide} may end in {@code restitution=NUMBER}; without it, it is 1.
 *   <li>Any row but {@code collide} may end in {@code response=bounce}, {@code halt} or {@code
 *       sensor}, of the bounds not the last of them, see {@link Response}; a line's row in {@code
 *       oneway=1}, see {@link SceneBuilder#oneWay()}.
 *   <li>Blank lines, spaces and tabs around fields, {@code #} comments on lines of their own or
 *       after a row, either kind of line end, and a byte order mark are passed over.
 * </ul>
 *
 * <p>Everything else is a {@link SceneFormatException} that names file, line and column, and
 * nothing is loaded. What is written reads back as an equal scene, to the bit.
 */
public final class SceneFile {

  private SceneFile() {}

  /**
   * Reads a scene.
   *
   * @param path the file
   * @return the scene
   * @throws SceneFormatException if the file does not follow the format, or holds what {@link
   *     SceneBuilder} refuses
   * @throws IOException if the file cannot be read
   */
  public static Scene read(Path path) throws IOException {
    // A reader of its own, since those of Files stop at a comment that is not UTF-8.
    try (Reader in = new InputStreamReader(Files.newInputStream(path), StandardCharsets.UTF_8)) {
      return read(in, path.toString());
    }
  }

  /**
   * Reads a scene.
   *
   * @param in where to read, to its end; it is not closed
   * @param name what to call it in messages
   * @return the scene
   * @throws SceneFormatException if the text does not follow the format, or holds what {@link
   *     SceneBuilder} refuses
   * @throws IOException if reading fails
   */
  public static Scene read(Reader in, String name) throws IOException {
    return new SceneReader(name).read(in);
  }

  /**
   * Writes a scene to a file; one that stands there is replaced, at the end and as a whole, so that
   * a failure leaves it as it was.
   *
   * @param scene the scene
   * @param path the file
   * @throws IOException if the file cannot be written
   */
  public static void write(Scene scene, Path path) throws IOException {
    if (Files.exists(path) && !Files.isRegularFile(path)) {
      writeDirectly(scene, path, StandardOpenOption.WRITE); // a pipe or a device: no file to spare
      return;
    }
    Path target = Files.exists(path) ? path.toRealPath() : path;
    String random = Long.toHexString(ThreadLocalRandom.current().nextLong());
    Path draft = target.resolveSibling(target.getFileName() + "." + random + ".tmp");
    try {
      writeDirectly(scene, draft, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
      Files.move(
          draft, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(draft);
    }
  }

  private static void writeDirectly(Scene scene, Path path, StandardOpenOption... options)
      throws IOException {
    try (Writer out = Files.newBufferedWriter(path, options)) {
      write(scene, out);
    }
  }

  /**
   * Writes a scene: wall, lines, pegs, circles, each kind in the order of its numbers.
   *
   * @param scene the scene
   * @param out where to write; it is neither flushed nor closed
   * @throws IOException if writing fails
   */
  public static void write(Scene scene, Appendable out) throws IOException {
    new SceneWriter(out).write(scene);
  }
}
