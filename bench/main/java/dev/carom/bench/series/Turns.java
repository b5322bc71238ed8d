// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

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
  <T> void round(Collection<T> contenders, Consumer<? super T> play) {
    List<T> order = new ArrayList<>(contenders);
    Collections.shuffle(order, random);
    order.forEach(play);
  }
}
