// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.peers.Peers;
import dev.carom.bench.results.Row;
import java.util.List;
import org.junit.jupiter.api.Test;

class BouncePartTest {

  @Test
  void errorsAreToldAfterRoundNumbersOfBounces() {
    List<Row> rows = new BouncePart(Methods.CAROM, 1000).run();
    assertThat(rows)
        .extracting(Row::stat)
        .containsExactly(
            "worst@1",
            "worst@2",
            "worst@5",
            "worst@10",
            "worst@20",
            "worst@50",
            "worst@100",
            "worst@200",
            "worst@500",
            "worst@1000");
    assertThat(rows).extracting(Row::value).allMatch(error -> error < 1e-14);
  }

  @Test
  void theBallReachesTheFloorAndComesBack() {
    try (Method method = Methods.CAROM.start(BouncePart.scene())) {
      double lowest = method.y(0);
      for (int frame = 0; frame < 384; frame++) {
        method.frame();
        lowest = Math.min(lowest, method.y(0));
      }
      assertThat(lowest).isBetween(10.0, 10.5);
      assertThat(method.y(0)).isBetween(32.9, 33.0);
    }
  }

  @Test
  void enginesGainOrLoseEnergy() {
    for (Contender peer : Peers.all()) {
      List<Row> rows = new BouncePart(peer, 10).run();
      assertThat(rows).as(peer.id()).isNotEmpty();
      if (!rows.get(0).metric().equals("failure")) {
        assertThat(rows.get(rows.size() - 1).value()).as(peer.id()).isGreaterThan(1e-9);
      }
    }
  }

  @Test
  void whoKnowsNoGravitySaysSo() {
    List<Row> rows = new BouncePart(Methods.POSTER, 1).run();
    assertThat(rows).hasSize(1);
    assertThat(rows.get(0).metric()).isEqualTo("failure");
    assertThat(rows.get(0).stat()).contains("gravity");
  }
}
