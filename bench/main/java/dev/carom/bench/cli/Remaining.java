// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Locale;

/** Tells of each part of a long run that is done, and how long the rest may take. */
final class Remaining {

  private final Progress progress;
  private final PrintWriter out;
  private final long start = System.nanoTime();
  private long last = start;
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
      out.printf("%d of %d: %s%s%n", done, of, part, kept ? ", kept" : took() + rest(of - done));
      out.flush();
    }
    last = System.nanoTime();
  }

  private String took() {
    return String.format(Locale.ROOT, ", %.1f s", (System.nanoTime() - last) / 1e9);
  }

  /** As long, on average, as those that were measured now. */
  private String rest(int parts) {
    long each = (System.nanoTime() - start) / measured;
    long minutes = Duration.ofNanos(each * parts).plusSeconds(59).toMinutes();
    return parts == 0 ? "" : ", about " + minutes + " min left";
  }
}
