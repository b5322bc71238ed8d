// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.RungCounts;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.peers.Contenders;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** The whole comparison, cut into parts. */
public final class Parts {

  private static final int FORKS = 5;
  private static final int QUICK_FORKS = 2;

  private static final List<String> SCENES =
      List.of("base-1", Subjects.SMALL, "fast-1", "radii", "base-2", "base-3");

  /** The scenes whose frames are timed. */
  private static final List<String> TIMED = SCENES.subList(0, 4);

  /** What a quick comparison leaves out. */
  private static final Set<String> LATER =
      Set.of(
          "advancement-1e-4",
          "advancement-1e-8",
          "advancement-1e-10",
          "substeps-2",
          "substeps-8",
          "substeps-32",
          "substeps-128",
          "substeps-256");

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
    List<Part> parts = new ArrayList<>(scenes(quick));
    for (String name : Queries.classes()) {
      parts.add(new QueryPart(name, quick ? 1_000 : 20_000));
    }
    for (int fork = 0; fork < (quick ? QUICK_FORKS : FORKS); fork++) {
      parts.add(new QueryTimePart(fork, quick ? 200 : 1_500));
      for (String scene : quick ? SCENES.subList(0, 1) : TIMED) {
        parts.add(time(scene, fork, quick));
      }
    }
    return List.copyOf(parts);
  }

  private static List<Part> scenes(boolean quick) {
    List<Part> parts = new ArrayList<>();
    for (String scene : quick ? SCENES.subList(0, 1) : SCENES) {
      parts.add(new UlpPart(scene));
      for (Contender contender : contenders(quick)) {
        parts.add(new ScenePart(scene, contender));
      }
    }
    return parts;
  }

  private static Part time(String scene, int fork, boolean quick) {
    return new TimePart(scene, fork, contenders(quick), quick ? 2 : 4, quick ? 100 : 1_000);
  }

  /** In a hurry every method and peer, but of its knob only every other value. */
  private static List<Contender> contenders(boolean quick) {
    List<Contender> all = Contenders.all();
    return quick ? all.stream().filter(c -> !LATER.contains(c.id())).toList() : all;
  }
}
