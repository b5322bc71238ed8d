// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Scene;

/**
 * Something to compare: a method or peer with one value of its knob.
 *
 * @param id its name in files and options, unique
 * @param method the label of the method or peer
 * @param knob the setting, {@code name=value}; empty if the method has none
 * @param starter sets a scene in motion
 */
public record Contender(String id, String method, String knob, Starter starter) {

  /** Sets a scene in motion. */
  @FunctionalInterface
  public interface Starter {

    /**
     * Sets a scene in motion.
     *
     * @param scene the scene at time 0
     * @return the method, ready for its first frame
     */
    Method start(Scene scene);
  }

  /**
   * Sets a scene in motion. A circle's state is set by the scene: who wants to go on from another
   * state starts a scene that has it.
   *
   * @param scene the scene at time 0
   * @return the method, ready for its first frame
   * @throws UnsupportedOperationException if it cannot run on this machine, or not this scene; the
   *     message says why
   */
  public Method start(Scene scene) {
    return starter.start(scene);
  }

  @Override
  public String toString() {
    return knob.isEmpty() ? method : method + " " + knob;
  }
}
