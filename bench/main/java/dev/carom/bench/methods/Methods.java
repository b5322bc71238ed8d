// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Scene;

/** The methods that a replay compares. */
public enum Methods {
  /** This library. */
  CAROM("carom") {
    @Override
    public Method start(Scene scene) {
      return new CaromMethod(scene);
    }
  },
  /** The published algorithm. */
  POSTER("poster") {
    @Override
    public Method start(Scene scene) {
      return new Poster(scene);
    }
  };

  private final String label;

  Methods(String label) {
    this.label = label;
  }

  /**
   * The name of the method in tables, files and options.
   *
   * @return the name
   */
  public String label() {
    return label;
  }

  /**
   * Sets a scene in motion.
   *
   * @param scene the scene at time 0
   * @return the method, ready for its first frame
   */
  public abstract Method start(Scene scene);
}
