// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

/** The order of events with equal times. */
public interface EventOrder {

  /** Whether the event of circle i comes before that of circle j. */
  boolean before(int i, int j);
}
