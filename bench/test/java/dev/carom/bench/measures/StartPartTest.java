// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.methods.Methods;
import dev.carom.bench.results.Row;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

class StartPartTest {

  @Test
  @Tag("long")
  void aFreshMachineTellsItsFirstFrameAndTheSlowestAfterIt() {
    List<Row> rows = new StartPart(2, List.of(Methods.CAROM)).run();

    assertThat(rows).extracting(Row::stat).containsExactly("first", "worst");
    assertThat(rows).allMatch(row -> row.value() > 0 && row.fork() == 2 && row.unit().equals("ns"));
  }
}
