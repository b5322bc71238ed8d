// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.bench.experiment.CannotPlaceException;
import java.util.Locale;

/**
 * Prints the hashes of the short golden runs, one a line, as {@code hashes.properties} holds them.
 *
 * <p>A program of its own, on the base module alone, so that it can be made a native image.
 */
public final class GoldenHashes {

  private GoldenHashes() {}

  /**
   * Runs it.
   *
   * @param args none
   * @throws CannotPlaceException never: the scenes are fixed
   */
  public static void main(String... args) throws CannotPlaceException {
    for (GoldenRun run : GoldenRun.values()) {
      System.out.printf(Locale.ROOT, "%s=%s%n", run.label(false), run.play(false).hex());
    }
  }
}
