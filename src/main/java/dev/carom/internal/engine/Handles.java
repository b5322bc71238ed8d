// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.KindNumber;

/**
 * The ids by which callers name obstacles and circles. The ids of each kind begin at 0 and are
 * never reused. Internally a {@link KindNumber} and an id (for a circle, its slot) form one code,
 * see {@link Codes} and {@link CircleRegistry}.
 */
public final class Handles {

  private final CircleRegistry registry;
  private final ObstacleTable obstacles;

  public Handles(CircleRegistry registry, ObstacleTable obstacles) {
    this.registry = registry;
    this.obstacles = obstacles;
  }

  /** Whether an id, which may be any int, exists. */
  public boolean contains(int kind, int id) {
    return kind == KindNumber.CIRCLE
        ? registry.slot(id) >= 0
        : id >= 0 && id < end(kind) && obstacles.isThere(obstacles.code(kind, id));
  }

  /** One more than the largest id ever given. */
  public int end(int kind) {
    return kind == KindNumber.CIRCLE ? registry.idLimit() : obstacles.end(kind);
  }

  /** The slot of a circle; refuses an id that does not exist. */
  public int circle(int id) {
    int slot = registry.slot(id);
    if (slot < 0) {
      throw missing(KindNumber.CIRCLE, id);
    }
    return slot;
  }

  /**
   * The code of an obstacle or a circle; of an outline, that of its first side. Refuses an id that
   * does not exist.
   */
  public int checked(int kind, int id) {
    if (!contains(kind, id)) {
      throw missing(kind, id);
    }
    return code(kind, id);
  }

  private int code(int kind, int id) {
    return kind == KindNumber.CIRCLE ? Codes.circle(registry.slot(id)) : obstacles.code(kind, id);
  }

  private IndexOutOfBoundsException missing(int kind, int id) {
    int end = end(kind);
    boolean removed = id >= 0 && id < end;
    String others = end == 0 ? "there is none" : "expected an id from 0 to " + (end - 1);
    String gone = kind == KindNumber.WALL ? "the bounds are open there" : "it was removed";
    String reason = removed ? gone : others;
    return new IndexOutOfBoundsException(
        "%s does not exist: %s".formatted(KindNumber.nameOf(kind, id), reason));
  }
}
