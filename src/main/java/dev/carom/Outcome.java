// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/** How a step of a world, or the trace of a circle, ended. */
public enum Outcome {
  /** The time asked for was reached. */
  COMPLETE,
  /**
   * The budget of work was spent first. Everything stands, consistently, at an earlier time;
   * nothing was dropped, and the next call goes on from there.
   */
  UNFINISHED
}
