// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import java.util.Arrays;

/** The pairs of each awake circle, in chains. */
final class Links {

  private final int[] head;
  private NearPairs pairs;
  private int[] ofOwner = new int[0];
  private int[] ofOther = new int[0];

  Links(int circles) {
    head = new int[circles + 1];
  }

  void chain(NearPairs p, int awake, int[] order) {
    pairs = p;
    if (ofOwner.length < p.size) {
      ofOwner = new int[p.owner.length];
      ofOther = new int[p.owner.length];
    }
    Arrays.fill(head, -1);
    for (int k = p.size - 1; k >= 0; k--) {
      ofOwner[k] = head[p.owner[k]];
      head[p.owner[k]] = k;
      if (p.part[k] < 0) {
        ofOther[k] = head[p.other[k]];
        head[p.other[k]] = k;
      }
    }
  }

  int first(int i) {
    return head[i];
  }

  int next(int i, int k) {
    return pairs.owner[k] == i ? ofOwner[k] : ofOther[k];
  }

  /** 1 if the normal of a pair points to the circle, else -1. */
  double sign(int i, int k) {
    return pairs.owner[k] == i ? 1 : -1;
  }
}
