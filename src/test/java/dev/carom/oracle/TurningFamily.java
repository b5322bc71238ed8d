// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.function.Function;

/**
 * A kind of query about a thing that turns.
 *
 * @param name its name in tables
 * @param generator makes one
 */
public record TurningFamily(String name, Function<Draw, TurningQuery> generator) {

  /** The next query that makes sense. */
  public TurningQuery next(Draw d) {
    TurningQuery query = generator.apply(d);
    while (!query.isFair()) {
      query = generator.apply(d);
    }
    return query;
  }
}
