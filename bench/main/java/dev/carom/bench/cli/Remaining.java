// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.measures.Part;
import dev.carom.bench.replay.Counted;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;

/**
 * Tells how long a long run may take, of each part that is done, and how long the rest may take: as
 * the parts estimate it, and by how much those that were measured took longer or shorter.
 */
final class Remaining {

  private final Progress progress;
  private final PrintWriter out;
  private double left;
  private double estimated;
  private double measured;
  private long last = System.nanoTime();

  /** Where there is a bar it tells; elsewhere a line a part is written. */
  Remaining(List<Part> parts, Progress progress, PrintWriter out) {
    this.progress = progress;
    this.out = out;
    left = parts.stream().mapToDouble(Part::seconds).sum();
    out.printf(
        "%s, %s on two cores if nothing is kept%n", Counted.of(parts.size(), "part"), about(left));
    out.flush();
  }

  void tell(Part part, int done, int of, boolean kept) {
    left -= part.seconds();
    double seconds = (System.nanoTime() - last) / 1e9;
    last = System.nanoTime();
    if (!kept) {
      estimated += part.seconds();
      measured += seconds;
    }
    String rest = done == of ? "" : ", " + rest() + " left";
    progress.step(part.id() + rest);
    if (!progress.isShown()) {
      String took = String.format(Locale.ROOT, "%.1f s", seconds);
      out.printf("%d of %d: %s, %s%s%n", done, of, part.id(), kept ? "kept" : took, rest);
      out.flush();
    }
  }

  private String rest() {
    return about(estimated == 0 ? left : left * measured / estimated);
  }

  /** In whole minutes, of which one has begun. */
  static String about(double seconds) {
    return "about " + (int) Math.ceil(seconds / 60) + " min";
  }
}
