// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Falls;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.sweep.TurningFalls;
import dev.carom.oracle.Answer;
import dev.carom.oracle.Family;
import dev.carom.oracle.Part;
import dev.carom.oracle.Tally;
import dev.carom.oracle.TurningFamilies;
import dev.carom.oracle.TurningQuery;
import dev.carom.oracle.TurningQuery.Kind;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * The promise of exactness for lines and pegs that turn, held to an oracle that shares no code with
 * the detector: no wrong decision, every time the correctly rounded one, no normal of an impact
 * beyond 1e-15; first impacts, returns to what was just hit, and later entries, with and without an
 * acceleration.
 *
 * <p>More queries, and others (the oracle takes some 5 ms for each): {@code mvn -pl src test
 * -Dtest=TurningExactnessTest -Dcarom.queries=1000000 -Dcarom.seed=2}. Those of some families
 * alone: {@code -Dcarom.families=.*touching.*}. Prints a table.
 */
class TurningExactnessTest {
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final long QUERIES = Long.getLong("carom.queries", 1_320);
  private static final int CHUNK = 20;

  private static List<Family<TurningQuery>> families() {
    return FamilyTallies.chosen(TurningFamilies.all().stream());
  }

  @Test
  void answersGeneratedQueries() {
    FamilyTallies.judge(TurningExactnessTest::ask, families(), QUERIES, CHUNK);
  }

  /** A detector that takes the thing to turn evenly, not as the rational motion does, is seen. */
  @Test
  void anotherMotionIsNotOverlooked() {
    Tally tally =
        FamilyTallies.tally(
            query -> {
              double[] n = query.numbers();
              n[14] = n[14] * (1 + 0x1p-40) + 0x1p-40 * n[15]; // q1
              return ask(TurningQuery.of(query.kind(), n));
            },
            families(),
            5);
    assertTrue(tally.notNearest() + tally.wrongDecisions() > 50, tally.row("another motion"));
  }

  private static Answer ask(TurningQuery q) {
    double[] answer = TurningFalls.answer(q.kind().ordinal(), q.numbers());
    double time = answer[0];
    if (time == NEVER) {
      return Answer.MISS;
    }
    boolean isReturn = q.kind() == Kind.RETURN;
    int contact = (int) answer[1];
    assertEquals(time == 0, (contact & Contact.NOW) != 0);
    Part part = q.isLine() ? Falls.part(contact) : Part.CIRCLE;
    if (isReturn && part != Part.SIDE) {
      // Of an end that is touched by definition the normal is that of a rounded place.
      return new Answer(time, part, q.truth().normal().x().near(), q.truth().normal().y().near());
    }
    if (!q.isLine() && time > 0) {
      contact = Contact.LATER;
    }
    Hit hit =
        new Hit()
            .of(
                TurningFalls.fall(q.numbers()),
                q.isLine() || time > 0 ? contact : Contact.NOW,
                time);
    return new Answer(time, part, hit.nx(), hit.ny());
  }
}
