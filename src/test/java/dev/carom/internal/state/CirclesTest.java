// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.WallSweep;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is kept of a circle in the arrays is there when it is loaded. */
class CirclesTest {

  /** Of what is ahead, its contact; where nothing is, the sensor met last in its place. */
  @ParameterizedTest
  @CsvSource({
    Mover.NOTHING + ", 0",
    Mover.NOTHING + ", " + Obstacles.PEGS,
    WallSweep.LEFT + ", 0",
    Obstacles.WALLS + ", " + Contact.NOW
  })
  void whatIsKeptIsLoaded(int next, int contact) {
    Mover m = new Mover();
    m.start(1, 3, 4, 5, 6, 7, 0.5);
    m.next = next;
    m.contact = contact;
    m.t = 2;
    m.tl = 0x1p-60;
    m.cleared = 8;
    m.stuck = 9;
    m.pace = -10;
    m.last = 11;
    m.reach = 12;
    m.jam = Jam.with(null, 13);
    for (Circles circles : new Circles[] {new Circles(2), Circles.colliding(2)}) {
      circles.keep(1, m);
      circles.load(1);
      assertThat(circles.mover).usingRecursiveComparison().isEqualTo(m);
    }
  }
}
