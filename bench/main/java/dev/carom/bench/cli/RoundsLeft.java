// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.io.PrintWriter;

/** Tells of each of a run's equal rounds, and how long the rest take if they take as long. */
final class RoundsLeft {

  private final Progress progress;
  private final PrintWriter out;
  private final long start = System.nanoTime();

  /** Where there is a bar it tells both; elsewhere a line a round is written. */
  RoundsLeft(Progress progress, PrintWriter out) {
    this.progress = progress;
    this.out = out;
  }

  void tell(int done, int of) {
    progress.step("round " + done);
    if (!progress.isShown()) {
      double each = (System.nanoTime() - start) / 1e9 / done;
      String rest = done == of ? "" : ", " + Remaining.about(each * (of - done)) + " left";
      out.printf("round %d of %d%s%n", done, of, rest);
      out.flush();
    }
  }
}
