// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.util.IntList;

/** Finds what may touch a circle, for {@link ContactGraph}. Circles are named by their numbers. */
public interface ContactSurroundings {

  /**
   * Adds the members, but for the circle itself, that it can meet and that may be nearer to it than
   * a given distance. The circle is at (x, y) now.
   */
  void membersNear(int slot, double x, double y, double reach, IntList into);

  /**
   * Adds the codes of the obstacles, and of the circles of infinite mass, that may be nearer to a
   * circle than a given distance. Some may be there twice, or be none that it can meet. The circle
   * is at (x, y) now.
   */
  void obstaclesNear(int slot, double x, double y, double reach, double now, IntList into);
}
