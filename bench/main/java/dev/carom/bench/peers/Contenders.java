// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.peers;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import java.util.ArrayList;
import java.util.List;

/** All that is compared: methods and peers. */
public final class Contenders {

  private Contenders() {}

  /** All of them: the methods, then the peers. */
  public static List<Contender> all() {
    List<Contender> all = new ArrayList<>(Methods.all());
    all.addAll(Peers.all());
    return List.copyOf(all);
  }

  /**
   * One of them.
   *
   * @throws IllegalArgumentException if there is none of this id
   */
  public static Contender byId(String id) {
    return all().stream()
        .filter(contender -> contender.id().equals(id))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(id + " is no method and no peer"));
  }
}
