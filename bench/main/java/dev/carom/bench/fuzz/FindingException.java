// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

/** Something that must not be, and what it takes to see it again. */
public final class FindingException extends Exception {

  private static final long serialVersionUID = 1;

  FindingException(String message, Throwable cause) {
    super(message, cause);
  }

  FindingException(String message) {
    super(message);
  }
}
