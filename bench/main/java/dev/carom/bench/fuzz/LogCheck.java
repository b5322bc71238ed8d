// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.World;

/** What each row of a log must be, and their order. */
final class LogCheck {

  /**
   * Of the length of a normal, which is made from one of any length by one root and two quotients.
   */
  private static final double NORMAL = 1e-14;

  private LogCheck() {}

  static void check(World world, double start) throws FindingException {
    ImpactLog log = world.impacts();
    double before = start;
    for (int row = 0; row < log.size(); row++) {
      double time = log.time(row);
      if (!(time >= before && time <= world.now())) {
        throw new FindingException(
            "row %d is at %s: expected %s to %s".formatted(row, time, before, world.now()));
      }
      before = time;
      checkRow(world, log, row);
    }
  }

  private static void checkRow(World world, ImpactLog log, int row) throws FindingException {
    double length = Math.hypot(log.nx(row), log.ny(row));
    boolean there =
        world.contains(Kind.CIRCLE, log.circle(row))
            && world.contains(log.kind(row), log.id(row))
            && Filters.meet(world, log.circle(row), log.kind(row), log.id(row));
    boolean numbers =
        Math.abs(length - 1) <= NORMAL
            && log.approachSpeed(row) >= 0
            && Double.isFinite(log.x(row) + log.y(row));
    if (!there || !numbers) {
      throw new FindingException(
          "row %d: circle %d, %s %d, at (%s, %s), normal (%s, %s), speed %s"
              .formatted(
                  row,
                  log.circle(row),
                  log.kind(row),
                  log.id(row),
                  log.x(row),
                  log.y(row),
                  log.nx(row),
                  log.ny(row),
                  log.approachSpeed(row)));
    }
  }
}
