// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.io.PrintWriter;
import java.time.Duration;

/** Tells of each part of a long run that is done, and how long the rest may take. */
final class Remaining {

  private final Progress progress;
  private final PrintWriter out;
  private final long start = System.nanoTime();
  private int measured;

  /** Where there is a bar it tells; elsewhere a line a part is written. */
  Remaining(Progress progress, PrintWriter out) {
    this.progress = progress;
    this.out = out;
  }

  void tell(String part, int done, int of, boolean kept) {
    progress.step(part);
    measured += kept ? 0 : 1;
    if (!progress.isShown()) {
      out.printf("%d of %d: %s%s%n", done, of, part, kept ? ", kept" : rest(of - done));
      out.flush();
    }
  }

  /** As long, on average, as those that were measured now. */
  private String rest(int parts) {
    long each = (System.nanoTime() - start) / measured;
    long minutes = Duration.ofNanos(each * parts).plusSeconds(59).toMinutes();
    return parts == 0 ? "" : ", about " + minutes + " min left";
  }
}
