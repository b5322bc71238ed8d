// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

/** The value that stands for a missing index. */
public final class Index {

  /** No circle: the end of a linked list of indices, or a search without result. */
  public static final int NONE = -1;

  private Index() {}
}
