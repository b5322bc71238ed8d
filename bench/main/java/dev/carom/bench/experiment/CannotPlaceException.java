// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

/** A scene that was asked for has no room, or so little that chance does not find it. */
public final class CannotPlaceException extends Exception {

  private static final long serialVersionUID = 1;

  CannotPlaceException(String message) {
    super(message);
  }
}
