// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.function.Function;

/**
 * A kind of query about a circle with a constant acceleration.
 *
 * @param name its name in tables
 * @param generator makes one
 */
public record ParabolaFamily(String name, Function<Draw, ParabolaQuery> generator) {

  /** The next query; all its numbers are finite, but for the end of the window. */
  public ParabolaQuery next(Draw d) {
    ParabolaQuery query = generator.apply(d);
    while (!query.isFinite()) {
      query = generator.apply(d);
    }
    return query;
  }
}
