// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.sweep.Contact;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** A circle that is stored in the arrays is the same when it is loaded. */
class CircleTableTest {

  /** The next impact and its contact; without one, the sensor met last stands in its place. */
  static Stream<Arguments> aheadAndContact() {
    return Stream.of(
        Arguments.of(MovingCircle.NOTHING, 0, 0),
        Arguments.of(MovingCircle.NOTHING, 0, Codes.peg(0)),
        Arguments.of(Codes.LEFT, 0, 0),
        Arguments.of(Codes.line(0), Contact.NOW, 0));
  }

  @ParameterizedTest
  @MethodSource("aheadAndContact")
  void whatIsKeptIsLoaded(int next, int contact, int sensedCode) {
    MovingCircle m = new MovingCircle();
    m.start(1, 3, 4, 5, 6, 7, 0.5);
    m.next = next;
    m.contact = contact;
    m.sensedCode = sensedCode;
    m.t = 2;
    m.tl = 0x1p-60;
    m.cleared = 8;
    m.stuck = 9;
    m.speedExponent = -10;
    m.last = 11;
    m.lookahead = 12;
    m.jam = IgnoreList.with(null, 13);
    for (CircleTable circles : new CircleTable[] {new CircleTable(2), CircleTable.colliding(2)}) {
      circles.put(1, m);
      circles.load(1);
      assertThat(circles.body).usingRecursiveComparison().isEqualTo(m);
    }
  }
}
