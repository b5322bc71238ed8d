// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Scene;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.reference.References;
import dev.carom.bench.stability.FailureMap;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.Supplier;

/**
 * A scene that can be chosen.
 *
 * @param title its name
 * @param scene makes the scene
 * @param truth computes or reads its true course; the result may be null
 */
record SceneChoice(String title, Supplier<Scene> scene, Supplier<Reference> truth) {

  /** One of the experiment. */
  static SceneChoice stored(String name) {
    return new SceneChoice(
        name, () -> read(() -> References.scene(name)), () -> read(() -> References.load(name)));
  }

  /** Reads something from the jar. */
  @FunctionalInterface
  private interface Reader<T> {
    T read() throws IOException;
  }

  private static <T> T read(Reader<T> reader) {
    try {
      return reader.read();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A cell of a map. */
  static SceneChoice of(FailureMap map, int column, int row) {
    String title = map.x().label() + ": " + map.x().text().apply(map.x().values()[column]);
    return new SceneChoice(title, () -> map.scene(column, row), () -> map.truth(column, row));
  }
}
