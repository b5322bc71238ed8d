// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.search.BoxTree;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.sweep.Hit;

/** The search for the first circle that a cast hits. */
final class FirstCircle implements BoxTree.First {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private final CircleTable circles;
  private final CircleRegistry registry;
  private final CircleIndex index;
  private final CastReach reach = new CastReach();
  private final CastTarget loaded = new CastTarget();

  /** The circle that was found before, where it has to be compared exactly. */
  private final CastTarget found = new CastTarget();

  private final Hit hit = new Hit();

  /** The circle that is tested. */
  private CastTarget target = loaded;

  // The cast.
  private MovingCircle m;
  private Tracer tracer;
  private double maxTime;
  private double now;

  FirstCircle(CircleTable circles, CircleRegistry registry, CircleIndex index) {
    this.circles = circles;
    this.registry = registry;
    this.index = index;
  }

  /**
   * Finds the first circle that is hit before anything else, see {@link CircleQueries#first}.
   *
   * @param indexed whether the index is of that time; if not, each circle is tested
   */
  void find(MovingCircle cast, Tracer itsTracer, double until, double present, boolean indexed) {
    m = cast;
    tracer = itsTracer;
    maxTime = until;
    now = present;
    if (!indexed || index.tree() == null) {
      testEach();
    } else {
      reach.start(m, index);
      index.tree().first(this);
    }
  }

  private void testEach() {
    LiveCodes present = registry.present();
    for (int i = 0; i < present.size(); i++) {
      int slot = present.get(i);
      if (index.isThere(slot, now)) {
        target = loaded.load(circles, slot, now);
        test(slot);
      }
    }
  }

  @Override
  public double entry(int node) {
    return reach.entry(node);
  }

  @Override
  public double limit() {
    return Math.min(end(), Double.MAX_VALUE);
  }

  @Override
  public void look(int place) {
    target = index.circle(place);
    boolean falls = target.isFalling() || m.isFalling();
    if (!falls || !(reach.entry(target) > limit())) {
      test(index.tree().item(place));
    }
  }

  /** The time beyond which no contact is of interest. */
  private double end() {
    return m.next == MovingCircle.NOTHING ? maxTime : m.cleared;
  }

  /** Keeps the contact with a loaded circle if it is the first one. */
  private void test(int slot) {
    if (slot == m.id
        || registry.isSensor(slot)
        || !FilterBits.meet(m.filter, registry.filter(slot))) {
      return;
    }
    double limit = end();
    // A time that rounds to the limit is exactly before the next double.
    double t = target.time(m, Math.nextUp(limit));
    if (t > limit || t == NEVER || (t == limit && !isFirst(slot))) {
      return;
    }
    m.next = Codes.circle(slot);
    m.contact = target.contact();
    m.cleared = t;
  }

  /** Whether a contact is before the limit, with which its rounded time is equal. */
  private boolean isFirst(int slot) {
    int order = target.exactTime(m, target.contact()).compare(exactLimit());
    return order != 0 ? order < 0 : m.next == MovingCircle.NOTHING || Codes.circle(slot) < m.next;
  }

  /** The exact time of the first contact so far, or of the end of the cast. */
  private RealRoot exactLimit() {
    if (m.next == MovingCircle.NOTHING) {
      return RealRoot.at(Dyadic.of(maxTime));
    }
    return Codes.isCircle(m.next)
        ? found.load(circles, Codes.slot(m.next), now).exactTime(m, m.contact)
        : tracer.exactTime(m);
  }

  Hit hit(MovingCircle cast, double present) {
    return loaded.load(circles, Codes.slot(cast.next), present).hit(cast, hit);
  }
}
