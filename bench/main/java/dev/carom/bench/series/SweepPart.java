// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.bench.measures.CommandPart;
import dev.carom.bench.measures.Part;
import java.util.ArrayList;
import java.util.List;

/** One round of the sweep as a part of the report. */
public final class SweepPart {

  private static final int REPLAYS = 5;
  private static final int QUICK_REPLAYS = 2;
  private static final int QUICK_WARM_UP_MILLIS = 1000;

  private SweepPart() {}

  /**
   * Prepares it.
   *
   * @param fork the number of the virtual machine, from 0
   * @param quick whether a few scenes will do
   * @return the part
   */
  public static Part of(int fork, boolean quick) {
    List<String> command = new ArrayList<>(List.of("sweep", "--turns", Integer.toString(fork)));
    command.addAll(List.of("--replays", Integer.toString(quick ? QUICK_REPLAYS : REPLAYS)));
    if (quick) {
      command.addAll(List.of("--quick", "--warm-up", Integer.toString(QUICK_WARM_UP_MILLIS)));
    }
    return new CommandPart("sweep/fork-" + fork, quick ? 5 : 25, fork, command);
  }
}
