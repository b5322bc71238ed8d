// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.LineContender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.methods.RungCounts;
import dev.carom.bench.peers.Contenders;
import dev.carom.bench.peers.Peers;
import dev.carom.bench.reference.References;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** The whole comparison, cut into parts. */
public final class Parts {

  /** The virtual machines in which each time is taken anew. */
  public static final int FORKS = 5;

  private static final List<String> SCENES =
      List.of("base-1", Subjects.SMALL, "fast-1", "radii", "base-2", "base-3");

  /** Those that only repeat the first one with other random numbers. */
  private static final Set<String> REPEATED = Set.of("base-2", "base-3");

  /** Where a frame has so many impacts that its error is judged by its conditioning. */
  private static final String FAST = "fast-1";

  /** Values of knobs between others, which repeated scenes leave out. */
  private static final Set<String> BETWEEN =
      Set.of(
          "advancement-1e-4",
          "advancement-1e-8",
          "advancement-1e-10",
          "substeps-2",
          "substeps-8",
          "substeps-32",
          "substeps-128",
          "substeps-256");

  /** Further methods that a quick comparison leaves out, of frames and of questions. */
  private static final Set<String> LATER =
      Set.of(
          "advancement-1e-2",
          "substeps-4",
          "substeps-64",
          "advancement-1e-6",
          "closest-point-16",
          "closest-point-4096");

  private static final int WARM_UP_MILLIS = 800;
  private static final int QUERY_WARM_UP_MILLIS = 1_500;

  private Parts() {}

  /**
   * All parts. The library's work is counted, so this must be called before its first use in the
   * process.
   *
   * @param quick whether minutes must do: one scene, fewer settings and queries, shorter replays
   * @return parts, independent of each other, in a sensible order
   * @throws IllegalStateException if the library has been used without being counted
   */
  public static List<Part> of(boolean quick) {
    return of(quick, quick ? SCENES.subList(0, 1) : SCENES);
  }

  /**
   * The parts of some scenes, and those that belong to none.
   *
   * @param quick whether minutes must do
   * @param scenes their names
   * @return parts, as above
   * @throws IllegalArgumentException if there is no such scene; the message names all there are
   */
  public static List<Part> of(boolean quick, List<String> scenes) {
    for (String name : scenes) {
      if (!SCENES.contains(name)) {
        throw new IllegalArgumentException(
            "--scenes has " + name + ": expected " + String.join(", ", SCENES));
      }
    }
    RungCounts.enable();
    List<Part> parts = new ArrayList<>();
    scenes.forEach(scene -> addScene(parts, scene, quick));
    colliding().forEach(contender -> parts.add(new GasPart(Subjects.GAS, contender)));
    heaping().forEach(contender -> parts.add(new HeapPart(Subjects.HEAP, contender)));
    parts.add(new BouncePart(Methods.CAROM, quick ? 100_000 : 1_000_000));
    Peers.all().forEach(peer -> parts.add(new BouncePart(peer, quick ? 5_000 : 20_000)));
    parts.add(new TrustPart(References.FALLING));
    parts.add(new RungPart(scenes, quick ? 1_000 : 20_000));
    for (String name : Queries.classes()) {
      parts.add(new QueryPart(name, quick ? 1_000 : 20_000));
    }
    for (int fork = 0; fork < FORKS; fork++) {
      parts.add(queryTimes(fork, quick));
      for (String scene : scenes) {
        parts.add(frameTimes(scene, contenders(scene, quick), fork, quick));
      }
      parts.add(frameTimes(Subjects.GAS, colliding(), fork, quick));
      parts.add(frameTimes(Subjects.HEAP, heaping(), fork, quick));
      parts.add(new StartPart(fork, starting()));
    }
    return List.copyOf(parts);
  }

  private static void addScene(List<Part> parts, String scene, boolean quick) {
    parts.add(new UlpPart(scene));
    for (Contender contender : contenders(scene, quick)) {
      parts.add(new ScenePart(scene, contender));
    }
    if (scene.equals(SCENES.get(0))) {
      parts.add(new TrustPart(scene));
    }
    if (scene.equals(FAST)) {
      parts.add(new RoundingPart(scene));
    }
  }

  private static Part queryTimes(int fork, boolean quick) {
    List<String> ids =
        LineContender.all().stream()
            .map(LineContender::id)
            .filter(id -> !quick || !(BETWEEN.contains(id) || LATER.contains(id)))
            .toList();
    return new QueryTimePart(fork, ids, QUERY_WARM_UP_MILLIS);
  }

  private static Part frameTimes(
      String scene, List<Contender> contenders, int fork, boolean quick) {
    return new TimePart(scene, fork, contenders, quick ? 2 : 3, WARM_UP_MILLIS);
  }

  /** Every method and peer; of its knob, where there is little time, only some values. */
  private static List<Contender> contenders(String scene, boolean quick) {
    Stream<Contender> all = Contenders.all().stream();
    if (quick || REPEATED.contains(scene)) {
      all = all.filter(c -> !BETWEEN.contains(c.id()));
    }
    return all.filter(c -> !quick || !LATER.contains(c.id())).toList();
  }

  /** Those that know pairs of circles. */
  private static List<Contender> colliding() {
    List<Contender> all = new ArrayList<>(List.of(Methods.CAROM, Methods.OVERLAP));
    all.addAll(List.of(Methods.substeps(16), Methods.substeps(64)));
    all.addAll(Peers.all());
    return all;
  }

  /** Those that know gravity and contact. */
  private static List<Contender> heaping() {
    List<Contender> all = new ArrayList<>(List.of(Methods.CAROM));
    all.addAll(Peers.all());
    return all;
  }

  /** The library and the engines as they come. */
  private static List<Contender> starting() {
    return heaping().stream().filter(c -> !c.id().endsWith("-best")).toList();
  }

  /** A scene of the comparison, at time 0. */
  public static Scene scene(String name) {
    return Subjects.scene(name);
  }

  /** Lists the methods that a quick comparison leaves out, for people, and returns one line. */
  public static String leftOut() {
    return "the short run leaves out the scenes "
        + String.join(", ", SCENES.subList(1, SCENES.size()))
        + " (unless --scenes names them), and most values of knobs";
  }
}
