// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.duel;

import dev.carom.Scene;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.reference.Truth;
import java.util.Locale;
import java.util.function.Supplier;

/** Small scenes in which methods fail, each in its own way, within five seconds. */
@SuppressWarnings("ImmutableEnumChecker") // each maker is a static method
public enum Preset {
  FAST("Fast circles before thin lines", true, PresetScenes::fast),
  GAP("Gaps a hair wider, and a hair narrower, than the circle", true, PresetScenes::gap),
  CORNER("Acute corners, elastic", true, PresetScenes::corner),
  SHALLOW("Flights that nearly follow a wall", true, PresetScenes::shallow),
  SLOW("Bounces slower than half a pixel a frame", true, PresetScenes::slow),
  WEDGE("Circles that come to rest in wedges", false, PresetScenes::wedge),
  ROW("A circle runs into a row of others that touch", true, PresetScenes::row);

  /** Five seconds. */
  public static final int FRAMES = 300;

  private final String about;
  private final boolean known;
  private final Supplier<Scene> maker;

  Preset(String about, boolean known, Supplier<Scene> maker) {
    this.about = about;
    this.known = known;
    this.maker = maker;
  }

  /** The title of the scene: a phrase. */
  public String about() {
    return about;
  }

  /** The scene at time 0. */
  public Scene scene() {
    return maker.get();
  }

  /**
   * The true course, computed in as many digits as it needs: that takes up to a second.
   *
   * @return its course over five seconds; null where impacts pile up, so that there is none
   */
  public Reference truth() {
    return known ? Truth.of(scene(), FRAMES, () -> {}) : null;
  }

  /** Its name in options. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
