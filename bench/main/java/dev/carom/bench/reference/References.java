// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Scene;
import dev.carom.bench.results.WholeFile;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * The true courses of the experiment's scenes, and of one with gravity, over 600 frames, stored:
 * computed once, with as many digits as it takes, and read within a fraction of a second.
 */
public final class References {

  /** The experiment's scenes. */
  public static final List<String> SCENES =
      List.of("base-1", "base-2", "base-3", "fast-1", "radii");

  /** The obstacles of base-1 and 40 of its circles, under gravity. */
  public static final String FALLING = "falling";

  /** The scenes of which a reference is stored. */
  public static final List<String> STORED =
      Stream.concat(SCENES.stream(), Stream.of(FALLING)).toList();

  private static final String ROOT = "/dev/carom/bench/";

  private References() {}

  /**
   * Reads one of the stored references.
   *
   * @param scene a name of {@link #STORED}
   * @return the course of that scene over 600 frames
   * @throws IOException if there is none of that name
   */
  public static Reference load(String scene) throws IOException {
    try (InputStream in = open("references/" + fileName(scene))) {
      return ReferenceReader.read(in, scene);
    }
  }

  /**
   * Reads a scene that has a stored reference.
   *
   * @throws IOException if there is none of that name
   */
  public static Scene scene(String name) throws IOException {
    try (Reader in =
        new InputStreamReader(open("scenes/" + name + ".csv"), StandardCharsets.UTF_8)) {
      return Scene.read(in, name);
    }
  }

  /**
   * Stores a reference in a folder, made if it is not there, under the name by which it is read.
   *
   * @param truth the course to be stored
   * @return the size of the file in bytes
   * @throws IOException if it cannot be written
   */
  public static long write(Truth truth, String scene, Path folder) throws IOException {
    Files.createDirectories(folder);
    Path file = folder.resolve(fileName(scene));
    try (WholeFile whole = WholeFile.create(file)) {
      ReferenceWriter.write(truth, whole.out());
      whole.commit();
    }
    return Files.size(file);
  }

  private static String fileName(String scene) {
    return scene + ".flights";
  }

  private static InputStream open(String resource) throws IOException {
    InputStream in = References.class.getResourceAsStream(ROOT + resource);
    if (in == null) {
      throw new FileNotFoundException(
          "there is no " + resource + ": expected one of the scenes " + STORED);
    }
    return in;
  }
}
