// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.bench.measures.CommandPart;
import dev.carom.bench.measures.Part;
import java.util.ArrayList;
import java.util.List;

/** The sweep, the scale and the features as parts of the report, each cut into forks. */
public final class SeriesParts {

  private static final int ROUNDS = 101;
  private static final int QUICK_ROUNDS = 31;
  private static final int FEATURES_WARM_UP_MILLIS = 2000;
  private static final int REPLAYS = 5;
  private static final int QUICK_REPLAYS = 2;
  private static final int QUICK_SWEEP_WARM_UP_MILLIS = 1000;
  private static final int SCALE_WARM_UP_MILLIS = 800;
  private static final int MOST_QUICK_CIRCLES = 10_000;

  private SeriesParts() {}

  /**
   * One round of the sweep.
   *
   * @param fork the number of the virtual machine, from 0
   * @param quick whether a few scenes will do
   */
  public static Part sweep(int fork, boolean quick) {
    List<String> options = new ArrayList<>();
    options.addAll(List.of("--replays", Integer.toString(quick ? QUICK_REPLAYS : REPLAYS)));
    if (quick) {
      options.addAll(List.of("--quick", "--warm-up", Integer.toString(QUICK_SWEEP_WARM_UP_MILLIS)));
    }
    return part("sweep", quick ? 5 : 25, fork, options);
  }

  /**
   * One round of the times against the number of circles.
   *
   * @param fork the number of the virtual machine, from 0; the first one measures memory, too
   * @param quick whether up to ten thousand circles will do
   */
  public static Part scale(int fork, boolean quick) {
    List<String> options = new ArrayList<>();
    options.addAll(List.of("--rounds", "1", "--warm-up", Integer.toString(SCALE_WARM_UP_MILLIS)));
    if (quick) {
      options.addAll(List.of("--max", Integer.toString(MOST_QUICK_CIRCLES)));
    }
    if (fork > 0) {
      options.add("--no-memory");
    }
    return part("scale", quick ? 25 : 90, fork, options);
  }

  /**
   * One round of what the features of a scene cost.
   *
   * @param fork the number of the virtual machine, from 0; the first one measures memory, too
   * @param quick whether short rounds will do
   */
  public static Part features(int fork, boolean quick) {
    List<String> options = new ArrayList<>();
    options.addAll(List.of("--rounds", Integer.toString(quick ? QUICK_ROUNDS : ROUNDS)));
    options.addAll(List.of("--warm-up", Integer.toString(FEATURES_WARM_UP_MILLIS)));
    if (fork > 0) {
      options.add("--no-memory");
    }
    return part("features", quick ? 7 : 12, fork, options);
  }

  /**
   * Many small worlds on one thread and on each core.
   *
   * @param quick whether few worlds will do
   */
  public static Part worlds(boolean quick) {
    List<String> options = List.of("measure", "worlds", "--worlds", quick ? "2000" : "10000");
    return new CommandPart("worlds/all", quick ? 5 : 15, 0, options);
  }

  private static Part part(String command, double seconds, int fork, List<String> options) {
    List<String> arguments = new ArrayList<>();
    arguments.addAll(List.of("measure", command, "--turns", Integer.toString(fork)));
    arguments.addAll(options);
    return new CommandPart(command + "/fork-" + fork, seconds, fork, arguments);
  }
}
