// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.carom.PatchedDetector.Reply;
import dev.carom.internal.exact.BoundedNumber;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.sweep.SideSweep;
import dev.carom.internal.sweep.TimeOfImpact;
import dev.carom.internal.sweep.WallSweep;
import dev.carom.oracle.Brinks;
import dev.carom.oracle.Contact;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.Query;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.StringJoiner;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * No rounding bound is violated: the ladder answers as exact numbers alone do. And none is idle:
 * without it a query is answered wrongly. Prints a table of how much of each is needed.
 *
 * <p>More queries, and others: {@code mvn -pl src test -Dtest=RoundingBoundsTest
 * -Dcarom.queries=10000000 -Dcarom.seed=2}.
 */
@Tag("long")
class RoundingBoundsTest {
  private static final long QUERIES = Long.getLong("carom.queries", 108_000);

  /** With 7, queries of few families show that each bound is needed; the rarest is ROOT_PLACE. */
  private static final long SEED = Long.getLong("carom.seed", 7);

  private static final int CHUNK = 500;

  private final PatchedDetector exact = PatchedDetector.exact();
  private final List<Slack> slacks = Stream.of(RoundingBound.values()).map(Slack::new).toList();
  private final List<String> violations = new ArrayList<>();

  /** A query and its exact answer. */
  private record Known(Query query, Reply truth) {}

  @Test
  void everyBoundHoldsAndIsNeeded() {
    List<Family<Query>> families = new ArrayList<>(Families.all());
    families.addAll(Families.ofMovingLines());
    families.addAll(Brinks.all());
    long chunks = Math.max(1, QUERIES / families.size() / CHUNK);
    for (long chunk = 0; chunk < chunks; chunk++) {
      for (Family<Query> family : families) {
        ask(family, SEED * 1_000_000 + chunk);
      }
    }
    StringJoiner table = new StringJoiner("\n", "\n", "\n").add(Slack.HEAD);
    slacks.forEach(slack -> table.add(slack.row()));
    System.out.println(table);
    assertEquals(List.of(), violations);
    slacks.forEach(RoundingBoundsTest::assertNeeded);
  }

  private void ask(Family<Query> family, long seed) {
    Draw draw = Draw.of(seed, family.name());
    List<Query> queries = Stream.generate(() -> family.next(draw)).limit(CHUNK).toList();
    List<Known> known = queries.stream().map(this::known).toList();
    slacks.parallelStream().forEach(slack -> ask(slack, family.name(), known));
  }

  private Known known(Query query) {
    return new Known(query, exact.ask(query));
  }

  private void ask(Slack slack, String family, List<Known> known) {
    for (Known k : known) {
      if (slack.bound().concerns(k.query()) && slack.isViolatedBy(family, k.query(), k.truth())) {
        synchronized (violations) {
          violations.add(slack.bound() + ", " + family + ": " + k.query().hex());
        }
      }
    }
  }

  /** The oracle, too, says that the mistake is one. */
  private static void assertNeeded(Slack slack) {
    Query query = slack.witness();
    assertNotNull(query, () -> "no mistake without " + slack.bound());
    Contact contact = query.truth();
    Reply truth = new Reply(contact.part(), contact.time());
    String source = slack.bound() + ": " + query.hex();
    assertEquals(truth, PatchedDetector.scaled(slack.bound(), 1).ask(query), source);
    assertNotEquals(truth, slack.mistake(), source);
  }

  @Test
  void noBoundIsLeftOut() {
    Stream.of(
            TimeOfImpact.class,
            SideSweep.class,
            WallSweep.class,
            Predicates.class,
            BoundedNumber.class)
        .flatMap(owner -> Arrays.stream(owner.getDeclaredFields()))
        .filter(field -> Modifier.isStatic(field.getModifiers()) && field.getType() == double.class)
        .filter(field -> !field.getName().equals("MOST_SAFE"))
        .forEach(RoundingBoundsTest::assertListed);
  }

  private static void assertListed(Field constant) {
    assertTrue(
        Arrays.stream(RoundingBound.values()).anyMatch(bound -> bound.is(constant)),
        () -> "not tested: " + constant);
  }
}
