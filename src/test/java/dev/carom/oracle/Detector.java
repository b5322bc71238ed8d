// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** The code under test, as the oracle sees it: the one seam between the two. */
public interface Detector {
  Answer line(SegmentQuery query);

  /** A line that moves; not every detector knows one. */
  default Answer movingLine(MovingLineQuery query) {
    throw new UnsupportedOperationException("lines do not move here");
  }

  Answer pair(PairQuery query);

  Answer bounds(WallQuery query);
}
