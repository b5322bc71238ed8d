// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

/** The order of two events of the same time. */
public interface EventOrder {

  /** Whether the event of circle i comes before that of circle j. */
  boolean before(int i, int j);
}
