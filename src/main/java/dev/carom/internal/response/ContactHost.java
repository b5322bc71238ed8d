// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.util.IntList;
import dev.carom.internal.util.Part;

/** The services of an engine that {@link ContactCore} needs. Circles are named by their slots. */
public interface ContactHost {

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

  /** A member begins a flight now: it joined, a tick ended, it froze or woke. */
  void flies(int slot);

  /**
   * A circle is no member any more.
   *
   * @param side the code of the flat side over which it is left, or NONE
   */
  void frees(int slot, double vx, double vy, int side);

  /**
   * Something that moves passes over a circle.
   *
   * @param code the code of what presses on the circle, maybe another circle
   * @param part the {@link Part} of that
   * @param nx,ny the unit normal, from there to the circle
   */
  void jammed(int slot, int code, int part, double nx, double ny);
}
