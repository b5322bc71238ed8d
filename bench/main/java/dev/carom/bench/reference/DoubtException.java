// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

/** Tells that the digits carried do not decide a question: the run is to be made with more. */
final class DoubtException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  /** Without a stack trace: it is thrown and caught as a matter of course. */
  DoubtException() {
    super("the digits carried do not decide", null, false, false);
  }
}
