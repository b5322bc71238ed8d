// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.util.List;

/**
 * Something that a key does, and perhaps a button.
 *
 * @param keys as {@link javax.swing.KeyStroke#getKeyStroke(String)} takes them, at least one
 * @param label of the first of them, on the page of help
 * @param tip what it does, in a sentence without full stop
 */
record KeyAction(List<String> keys, String label, String name, String tip, Runnable action) {

  static KeyAction of(String key, String label, String name, String tip, Runnable action) {
    return new KeyAction(List.of(key), label, name, tip, action);
  }

  /** To be read over the button. */
  String hint() {
    return tip + " (" + label + ")";
  }
}
