// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.World;
import java.util.List;
import java.util.Set;

/** Tests that hold flights against what a world has in their way. */
abstract class FlightChecks {

  final Rounding rounding = new Rounding();
  final MassCheck masses = new MassCheck();
  final PassedOver passed = new PassedOver();

  void check(World world, Flight... flights) throws FindingException {
    rounding.keepPlace(100);
    rounding.keepSpeed(100, 100);
    masses.enter(world);
    new Crossings(world, rounding, masses, passed, Set.of())
        .check(List.of(flights).stream().map(List::of).toList());
  }

  void assertFound(String message, World world, Flight... flights) {
    assertThatThrownBy(() -> check(world, flights))
        .isInstanceOf(FindingException.class)
        .hasMessageContaining(message);
  }
}
