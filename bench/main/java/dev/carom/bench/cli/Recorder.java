// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.World;
import java.io.IOException;
import java.util.List;
import java.util.Locale;

/**
 * Writes positions and impacts of a world.
 *
 * @param positions where positions go, or null
 * @param impacts where impacts go, or null
 */
record Recorder(OutputFile positions, OutputFile impacts) {

  static final String[] POSITIONS = {"frame", "circle", "x", "y"};
  static final String[] IMPACTS = {
    "time", "circle", "obstacle", "feature", "x", "y", "nx", "ny", "speed", "outcome"
  };

  private static final List<String> WALLS = List.of("left", "right", "bottom", "top");

  void recordPositions(int frame, World world) throws IOException {
    if (positions == null) {
      return;
    }
    for (int id = 0; id < world.count(Kind.CIRCLE); id++) {
      positions.row(frame, id, Decimals.shortest(world.x(id)), Decimals.shortest(world.y(id)));
    }
  }

  void recordImpacts(ImpactLog log) throws IOException {
    if (impacts == null) {
      return;
    }
    for (int row = 0; row < log.size(); row++) {
      impacts.row(
          Decimals.shortest(log.time(row)),
          log.circle(row),
          obstacle(log.kind(row), log.id(row)),
          log.feature(row),
          Decimals.shortest(log.x(row)),
          Decimals.shortest(log.y(row)),
          Decimals.shortest(log.nx(row)),
          Decimals.shortest(log.ny(row)),
          Decimals.shortest(log.approachSpeed(row)),
          log.outcome(row));
    }
  }

  private static String obstacle(Kind kind, int number) {
    Object which = kind == Kind.WALL ? WALLS.get(number) : number;
    return (kind + " " + which).toLowerCase(Locale.ROOT);
  }

  void commit() throws IOException {
    if (positions != null) {
      positions.commit();
    }
    if (impacts != null) {
      impacts.commit();
    }
  }
}
