// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;

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

  /** Each of them plays once a round; the results of each, in the order of the rounds. */
  <T, R> Map<T, List<R>> rounds(int rounds, Collection<T> contenders, Function<? super T, R> play) {
    Map<T, List<R>> results = new LinkedHashMap<>();
    contenders.forEach(each -> results.put(each, new ArrayList<>()));
    for (int i = 0; i < rounds; i++) {
      round(contenders, each -> results.get(each).add(play.apply(each)));
    }
    return results;
  }

  /** Plays again and again for a time, and then no more. */
  static void warmUp(int millis, Runnable play) {
    long deadline = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
    while (System.nanoTime() < deadline) {
      play.run();
    }
  }
}
