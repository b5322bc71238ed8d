// SPDX-License-Identifier: Apache-2.0

/**
 * The harness of Carom: one runnable jar that measures speed and accuracy together, without a
 * screen. {@link dev.carom.bench.Main} is where it starts.
 */
package dev.carom.bench;
