// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/** What stands in place of an index. */
final class Index {

  /** No circle: the end of a list of indices, or an answer that there is none. */
  static final int NONE = -1;

  private Index() {}
}
