// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

/** What stands in place of an index. */
public final class Index {

  /** No circle: the end of a list of indices, or an answer that there is none. */
  public static final int NONE = -1;

  private Index() {}
}
