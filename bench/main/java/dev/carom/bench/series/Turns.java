// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.bench.methods.Contender;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;

/** Contenders take turns, in an order that is random anew in each round. */
final class Turns {

  private final Random random;

  Turns(long seed) {
    random = new Random(seed);
  }

  /** Each of them plays once. */
  void round(Collection<Contender> contenders, Consumer<Contender> play) {
    List<Contender> order = new ArrayList<>(contenders);
    Collections.shuffle(order, random);
    order.forEach(play);
  }
}
