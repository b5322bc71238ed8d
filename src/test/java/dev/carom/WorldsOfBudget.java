// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.EngineOptions;

/** Worlds whose steps may do less work, for tests of other packages. */
public final class WorldsOfBudget {

  private WorldsOfBudget() {}

  /** A world of a share of the usual budget. */
  public static World of(Scene scene, double share) {
    return new World(scene, EngineOptions.budget(share));
  }
}
