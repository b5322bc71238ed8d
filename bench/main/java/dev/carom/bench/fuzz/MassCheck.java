// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Outcome;
import dev.carom.World;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Infinite masses: only what stands still deflects one, and two of them pass through each other.
 * They pass over a circle that they have crushed, as long as it stands; for nobody else.
 */
final class MassCheck {

  private record Pair(int finite, int infinite) {}

  private World world;

  /** Since when an infinite mass may overlap a circle that it crushed. */
  private final Map<Pair, Double> crushed = new HashMap<>();

  /** Where this step is the first one in a world. */
  void enter(World entered) {
    world = entered;
  }

  /** Reads who was crushed in this step. */
  void read(ImpactLog log) throws FindingException {
    for (int row = 0; row < log.size(); row++) {
      int a = log.circle(row);
      int b = log.id(row);
      if (log.kind(row) == Kind.CIRCLE && isInfinite(a) && isInfinite(b)) {
        checkPassed(log, row);
      } else if (log.kind(row) == Kind.CIRCLE
          && log.outcome(row) == Outcome.JAMMED
          && (isInfinite(a) || isInfinite(b))) {
        crushed.putIfAbsent(isInfinite(a) ? new Pair(b, a) : new Pair(a, b), log.time(row));
      }
    }
  }

  private void checkPassed(ImpactLog log, int row) throws FindingException {
    Outcome outcome = log.outcome(row);
    if (outcome != Outcome.PASSED && outcome != Outcome.SENSED) {
      throw new FindingException(
          "infinite masses %d and %d: %s".formatted(log.circle(row), log.id(row), outcome));
    }
  }

  private boolean isInfinite(int id) {
    return world.contains(Kind.CIRCLE, id)
        && world.traits(Kind.CIRCLE, id).mass() == Double.POSITIVE_INFINITY;
  }

  /** Whether two circles may overlap in a part of their flights: one crushed the other. */
  boolean mayOverlap(Flight f, Flight g) {
    Flight finite = isInfinite(f.circle()) ? g : f;
    Flight infinite = isInfinite(f.circle()) ? f : g;
    Double since = crushed.get(new Pair(finite.circle(), infinite.circle()));
    return since != null && since <= finite.from() && finite.isStanding();
  }

  /** Forgets those that have left each other, when a step is over. */
  void end() {
    crushed.keySet().removeIf(pair -> !isInfinite(pair.infinite) || !overlap(pair));
  }

  private boolean overlap(Pair pair) {
    int i = pair.finite;
    int j = pair.infinite;
    return world.contains(Kind.CIRCLE, i)
        && Math.hypot(world.x(i) - world.x(j), world.y(i) - world.y(j))
            <= (world.radius(i) + world.radius(j)) * (1 + 0x1p-15);
  }

  /** The velocity of an infinite mass changes at obstacles only, to the bit. */
  void check(List<List<Flight>> flights) throws FindingException {
    Map<Integer, Set<Double>> turns = turns();
    for (List<Flight> of : flights) {
      for (int k = 1; k < of.size(); k++) {
        Flight f = of.get(k - 1);
        Flight g = of.get(k);
        boolean deflected = f.vx() != g.vx() || f.vy() != g.vy();
        boolean joined = f.to() == g.from();
        if (deflected
            && joined
            && isInfinite(f.circle())
            && world.scene().collide()
            && !turns.getOrDefault(f.circle(), Set.of()).contains(f.to())) {
          throw new FindingException("a circle deflected an infinite mass: %s, %s".formatted(f, g));
        }
      }
    }
  }

  /** When each circle met what stands still. */
  private Map<Integer, Set<Double>> turns() {
    Map<Integer, Set<Double>> turns = new HashMap<>();
    ImpactLog log = world.impacts();
    for (int row = 0; row < log.size(); row++) {
      if (log.kind(row) != Kind.CIRCLE) {
        turns.computeIfAbsent(log.circle(row), i -> new HashSet<>()).add(log.time(row));
      }
    }
    return turns;
  }
}
