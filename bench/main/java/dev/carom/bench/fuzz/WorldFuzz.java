// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import java.io.IOException;

/** Sessions one after the other, each from its own seed. */
public final class WorldFuzz {

  private long sessions;
  private long steps;
  private long flights;
  private long impacts;
  private long jams;

  /**
   * Plays one session.
   *
   * @throws FindingException if something is not as it must be; the message tells seed and scene
   */
  public void play(long seed) throws FindingException {
    Session session = null;
    try {
      session = new Session(seed);
      session.play();
    } catch (FindingException | IOException | RuntimeException | Error e) {
      throw new FindingException(
          "session %d: %s%n%s".formatted(seed, e, session == null ? "" : text(session)), e);
    }
    sessions++;
    StepWatch watch = session.watch();
    steps += watch.steps();
    flights += watch.flights();
    impacts += watch.impacts();
    jams += watch.jams();
  }

  private static String text(Session session) {
    StringBuilder text = new StringBuilder();
    try {
      session.scene().write(text);
    } catch (IOException e) {
      throw new AssertionError("a StringBuilder does not fail", e);
    }
    return text.toString();
  }

  public long sessions() {
    return sessions;
  }

  public long steps() {
    return steps;
  }

  public long flights() {
    return flights;
  }

  /** Impacts that jammed a circle. */
  public long jams() {
    return jams;
  }

  public long impacts() {
    return impacts;
  }
}
