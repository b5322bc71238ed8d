// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.file.Path;

/** The scene files among the test resources. */
public final class TestScenes {

  private TestScenes() {}

  /** The file {@code scenes/NAME}, such as base-1.csv. */
  public static Path path(String name) {
    try {
      return Path.of(TestScenes.class.getResource("/scenes/" + name).toURI());
    } catch (URISyntaxException e) {
      throw new IllegalArgumentException(e);
    }
  }

  /** The scene in the file {@code scenes/NAME}. */
  public static Scene read(String name) {
    try {
      return Scene.read(path(name));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
