// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.io.PrintWriter;
import java.time.Duration;

/** Tells of each of a run's equal rounds, and how long the rest take if they take as long. */
final class RoundsLeft {

  private final Progress progress;
  private final PrintWriter out;
  private final long start = System.nanoTime();

  /** Where there is a bar it tells; elsewhere a line a round is written. */
  RoundsLeft(Progress progress, PrintWriter out) {
    this.progress = progress;
    this.out = out;
  }

  void tell(int done, int of) {
    long each = (System.nanoTime() - start) / done;
    long minutes = Duration.ofNanos(each * (of - done)).plusSeconds(59).toMinutes();
    String rest = done == of ? "" : ", about " + minutes + " min left";
    progress.step("round " + done + rest);
    if (!progress.isShown()) {
      out.printf("round %d of %d%s%n", done, of, rest);
      out.flush();
    }
  }
}
