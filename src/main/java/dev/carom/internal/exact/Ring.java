// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/** Polynomials that can be added and multiplied, on any rung of precision. */
public interface Ring<P> {

  P plus(P that);

  P minus(P that);

  P times(P that);
}
