// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Scene;
import java.util.List;
import java.util.function.IntFunction;

/**
 * A run of some circles in which no digit was missing.
 *
 * @param bits how many it carried behind the point
 * @param needed how many were enough
 * @param hits the impacts in their order
 * @param courses what each circle did
 */
record Proof(int bits, int needed, List<Hit> hits, List<CircleFrames> courses) {

  private static final int FIRST_BITS = 128;
  private static final int MOST_BITS = 1 << 15;

  /** Two runs agree if no place differs by more, in units of the scene. */
  private static final double AGREEMENT = 1e-15;

  /** Doubles the digits until nothing is in doubt, and a run with twice as many agrees. */
  static Proof of(Scene scene, int[] circles, IntFunction<Lookout> lookouts, int frames) {
    Proof last = null;
    for (int bits = FIRST_BITS; bits <= MOST_BITS; bits *= 2) {
      Proof next = attempt(scene, circles, lookouts.apply(bits), frames, bits);
      if (last != null && next != null && next.agreesWith(last)) {
        return new Proof(bits, last.bits, next.hits, next.courses);
      }
      last = next;
    }
    throw new IllegalStateException(
        "circle %d: %d bits do not decide its course: expected fewer frames or impacts"
            .formatted(circles[0], MOST_BITS));
  }

  private static Proof attempt(Scene scene, int[] circles, Lookout lookout, int frames, int bits) {
    Run run = new Run(scene, circles, lookout, frames, bits);
    try {
      List<Hit> hits = run.play();
      return new Proof(bits, bits, hits, run.courses());
    } catch (DoubtException e) {
      return null;
    }
  }

  private boolean agreesWith(Proof that) {
    boolean near = hits.equals(that.hits);
    for (int i = 0; i < courses.size(); i++) {
      near &= courses.get(i).distance(that.courses.get(i)) <= AGREEMENT;
    }
    return near;
  }
}
