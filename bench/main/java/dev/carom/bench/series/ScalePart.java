// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.bench.measures.CommandPart;
import dev.carom.bench.measures.Part;
import java.util.ArrayList;
import java.util.List;

/** One round of the times against the number of circles as a part of the report. */
public final class ScalePart {

  private static final int WARM_UP_MILLIS = 800;
  private static final int QUICK_WARM_UP_MILLIS = 120;

  private ScalePart() {}

  /**
   * Prepares it.
   *
   * @param fork the number of the virtual machine, from 0; the first one measures memory, too
   * @param quick whether up to a thousand circles will do
   * @return the part
   */
  public static Part of(int fork, boolean quick) {
    List<String> command = new ArrayList<>(List.of("scale", "--rounds", "1"));
    command.addAll(List.of("--turns", Integer.toString(fork)));
    int warmUp = quick ? QUICK_WARM_UP_MILLIS : WARM_UP_MILLIS;
    command.addAll(List.of("--warm-up", Integer.toString(warmUp)));
    if (quick) {
      command.add("--quick");
    }
    if (fork > 0) {
      command.add("--no-memory");
    }
    return new CommandPart("scale/fork-" + fork, quick ? 2 : 90, fork, command);
  }
}
