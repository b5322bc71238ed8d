// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

/** Disjoint sets of numbers, as a union-find forest with halved paths. */
final class Groups {

  private final int[] parent;

  Groups(int room) {
    parent = new int[room];
  }

  /** Makes a set of each of the first so many numbers. */
  void clear(int count) {
    for (int i = 0; i < count; i++) {
      parent[i] = i;
    }
  }

  /** The number that stands for the set of i. */
  int of(int i) {
    int k = i;
    while (parent[k] != k) {
      parent[k] = parent[parent[k]];
      k = parent[k];
    }
    return k;
  }

  /** Joins the set of i to that of j. */
  void join(int i, int j) {
    parent[of(i)] = of(j);
  }
}
