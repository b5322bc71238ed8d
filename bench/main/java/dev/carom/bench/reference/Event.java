// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Kind;

/**
 * An impact that is foreseen: of a body with a target, or else with another body of a higher
 * number.
 */
record Event(Ball time, Touch contact, Body a, Target target, Body b) {

  Hit hit() {
    return target == null
        ? new Hit(a.id, Kind.CIRCLE, b.id, contact.feature())
        : new Hit(a.id, target.kind, target.index, contact.feature());
  }

  /** Simultaneous impacts are taken by kind, then by the numbers of what meets. */
  boolean isBefore(Event that) {
    int order = time.compareTo(that.time);
    return order < 0 || (order == 0 && isRankedBefore(hit(), that.hit()));
  }

  private static boolean isRankedBefore(Hit h, Hit k) {
    if (h.kind() != k.kind()) {
      return h.kind().compareTo(k.kind()) < 0;
    }
    boolean pair = h.kind() == Kind.CIRCLE;
    int first = pair ? h.circle() : h.obstacle();
    int second = pair ? h.obstacle() : h.circle();
    int firstOfK = pair ? k.circle() : k.obstacle();
    int secondOfK = pair ? k.obstacle() : k.circle();
    return first != firstOfK ? first < firstOfK : second < secondOfK;
  }
}
