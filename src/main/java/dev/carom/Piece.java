// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntFunction;

/**
 * Circles that are jammed together, and have to go on as one: with the velocity of their common
 * momentum, or not at all if one of them is stuck at something that stands still. Infinite masses
 * go on with the mean of their velocities, and take the finite ones along.
 *
 * <p>Where impact after impact with e = 0 does not get there, this is the end of it: nothing in the
 * piece approaches anything else in it any more, so each jam makes one piece of two, or leaves one
 * at rest. Energy is never added, since the mean of velocities has the least.
 */
final class Piece {

  private final Roster roster;
  private final PairResponse pairs;

  Piece(Roster roster, PairResponse pairs) {
    this.roster = roster;
    this.pairs = pairs;
  }

  /**
   * Gives the circles that are jammed to one or two, to these, and so on, one velocity, and writes
   * into the log through which other one each came to it.
   *
   * @param load gives a circle in flight, its own copy
   * @param hit one that has just hit what stands still, and stopped; or two that have just hit each
   *     other
   * @return all of them, at the start of their new flights
   */
  List<Mover> seize(IntFunction<Mover> load, ImpactLog log, Mover... hit) {
    List<Mover> members = gather(load, log, hit);
    double mass = 0;
    double vx = 0;
    double vy = 0;
    int infinite = 0;
    for (Mover m : members) {
      double own = roster.mass(m.id);
      mass += own;
      // So much of the mean is its own; infinite masses count alike, and beside them no other does.
      double part = own < Double.POSITIVE_INFINITY ? own / mass : 1.0 / ++infinite;
      vx = (1 - part) * vx + part * m.vx;
      vy = (1 - part) * vy + part * m.vy;
    }
    boolean stops = hit.length == 1;
    for (Mover m : members) {
      m.vx = stops ? 0 : vx;
      m.vy = stops ? 0 : vy;
      m.jam = Jam.ofCircles(m.jam, Obstacles.CIRCLES);
      m.last = Mover.NOTHING;
      m.newFlight();
    }
    return members;
  }

  private List<Mover> gather(IntFunction<Mover> load, ImpactLog log, Mover... hit) {
    List<Mover> members = new ArrayList<>(List.of(hit));
    BitSet seen = new BitSet();
    members.forEach(m -> seen.set(m.id));
    for (int k = 0; k < members.size(); k++) { // the list grows
      Mover m = members.get(k);
      int[] codes = m.jam == null ? new int[0] : m.jam.codes();
      for (int code : codes) {
        int id = code - Obstacles.CIRCLES;
        if (id >= 0 && !seen.get(id)) {
          Mover other = load.apply(id);
          if (holds(m, other)) {
            seen.set(id);
            members.add(other);
            pairs.report(m.id < id ? m : other, m.id < id ? other : m, log);
            log.setJammed();
          }
        }
      }
    }
    return members;
  }

  /** Whether two circles are still jammed; the other one is brought to the time of the first. */
  private static boolean holds(Mover m, Mover other) {
    if (other.jam == null || !other.jam.makesInert(Obstacles.CIRCLES + m.id)) {
      return false;
    }
    other.fly((m.t - other.t) + (m.tl - other.tl));
    other.t = m.t;
    other.tl = m.tl;
    return other.standsStill || ObstacleResponse.isInPlace(other);
  }
}
