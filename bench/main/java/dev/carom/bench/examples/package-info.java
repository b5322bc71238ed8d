// SPDX-License-Identifier: Apache-2.0

/**
 * Small programs that use the library as a game or a simulation would: each one file, on {@link
 * dev.carom.World} and a drawing class alone. {@code carom-bench example NAME} opens one in a
 * window; with {@code --png} it draws a picture of it instead.
 */
package dev.carom.bench.examples;
