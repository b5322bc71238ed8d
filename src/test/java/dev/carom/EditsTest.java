// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Edits, steps, snapshots and restores in random order: a world does what the plain model does,
 * which searches everything anew, and what another world does by other means and in other steps.
 * {@code -Dcarom.edits=1000000} makes a longer run of it, {@code -Dcarom.seed} another one.
 */
class EditsTest {

  private static final int EDITS = Integer.getInteger("carom.edits", 1_000);
  private static final int SEED = Integer.getInteger("carom.seed", 1);

  @Tag("long")
  @ParameterizedTest(name = "collide {0}, hard {1}, moving {2}")
  @CsvSource({
    "false, false, false", "true, false, false", "false, true, false", "true, true, false",
    "false, false, true", "true, false, true", "false, true, true", "true, true, true"
  })
  void theWorldDoesWhatThePlainModelDoes(boolean collide, boolean hard, boolean moving) {
    play(collide, hard, moving, false);
  }

  @Tag("long")
  @ParameterizedTest(name = "collide {0}, hard {1}, moving {2}")
  @CsvSource({
    "false, false, false", "true, false, false", "false, true, false", "true, true, false",
    "false, false, true", "true, false, true", "false, true, true", "true, true, true"
  })
  void underGravityTheWorldDoesWhatThePlainModelDoes(
      boolean collide, boolean hard, boolean moving) {
    play(collide, hard, moving, true);
  }

  private static void play(boolean collide, boolean hard, boolean moving, boolean falls) {
    int impacts = 0;
    int done = 0;
    int stuck = 0;
    int past = 0;
    for (int i = 0; done < EDITS; i++) {
      long seed = SEED * 1_000_003L + i * 500L;
      EditSession session = session(seed, collide, hard, i % 2 == 1, moving, falls);
      try {
        impacts += session.run();
      } catch (AssertionError | RuntimeException e) {
        throw new AssertionError(
            "session %d, collide %b, hard %b, moving %b, falls %b"
                .formatted(seed, collide, hard, moving, falls),
            e);
      }
      done += session.done();
      past += session.compared();
      stuck += session.isStuck() ? 1 : 0;
    }
    System.out.printf(
        "%,d edits, steps, snapshots and restores, collide %b, hard %b, moving %b, falls %b: %,d"
            + " impacts as in the plain model (%d sessions ended where a circle was stuck)%n",
        done, collide, hard, moving, falls, impacts, stuck);
    assertThat(impacts).isGreaterThan(EDITS / 8);
    assertThat(past).isGreaterThan(EDITS);
  }

  /** Hard numbers keep circles busy: such sessions are short. */
  private static EditSession session(
      long seed, boolean collide, boolean hard, boolean masked, boolean moving, boolean falls) {
    return hard
        ? new EditSession(seed, collide, true, masked, moving, falls, 120, 500)
        : new EditSession(seed, collide, false, masked, moving, falls, 500, 5_000);
  }

  /**
   * A line before a wall that is as good as touched; an edited circle whose line is moved; a line
   * removed that a circle was about to hit at once.
   */
  @ParameterizedTest
  @CsvSource({"7022521, false", "7016021, true", "5386515, true"})
  void sessionsThatOnceDiffered(long seed, boolean collide) {
    assertThat(session(seed, collide, false, false, false, false).run()).isPositive();
  }

  /**
   * So late that more than one cell is crossed, and more than one thing happens, within the time by
   * which now is rounded: an edit comes after all that, and needs everyone's cell of its own time.
   */
  @ParameterizedTest
  @ValueSource(longs = {18, 147, 245})
  void lateSessionsThatOnceDiffered(long seed) {
    assertThat(session(seed, true, true, false, false, false).run()).isPositive();
  }

  /** Short ones with gravity. */
  @ParameterizedTest
  @CsvSource({"8, false, false", "16, false, true", "11, true, false", "38, true, true"})
  void aSessionWithGravityDoesWhatThePlainModelDoes(long seed, boolean collide, boolean masked) {
    assertThat(new EditSession(seed, collide, false, masked, false, true, 60, 500).run())
        .isPositive();
  }

  /** Short ones, for who cannot wait for the long run. */
  @ParameterizedTest
  @CsvSource({"1, false, false", "2, true, false", "3, false, true", "4, true, true"})
  void aSessionDoesWhatThePlainModelDoes(long seed, boolean collide, boolean masked) {
    assertThat(session(seed, collide, false, masked, false, false).run()).isPositive();
  }
}
