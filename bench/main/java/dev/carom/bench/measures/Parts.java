// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.RungCounts;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.peers.Contenders;
import java.util.ArrayList;
import java.util.List;

/** The whole comparison, cut into parts. */
public final class Parts {

  private static final List<String> SCENES =
      List.of("base-1", Subjects.SMALL, "fast-1", "radii", "base-2", "base-3");

  private Parts() {}

  /**
   * All parts. The library's work is counted, so this must be called before its first use in the
   * process.
   *
   * @param quick whether minutes must do: one scene, fewer queries, two forks
   * @return parts, independent of each other, in a sensible order
   * @throws IllegalStateException if the library has been used without being counted
   */
  public static List<Part> of(boolean quick) {
    RungCounts.enable();
    List<Part> parts = new ArrayList<>();
    for (String scene : quick ? SCENES.subList(0, 1) : SCENES) {
      parts.add(new UlpPart(scene));
      for (Contender contender : Contenders.all()) {
        parts.add(new ScenePart(scene, contender));
      }
    }
    return List.copyOf(parts);
  }
}
