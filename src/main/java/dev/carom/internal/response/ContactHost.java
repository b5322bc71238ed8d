// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.util.Part;

/** The services of an engine that {@link ContactCore} needs. Circles are named by their slots. */
public interface ContactHost extends ContactSurroundings {

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
