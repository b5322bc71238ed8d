// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

/**
 * One of the pictures of a figure.
 *
 * @param title what stands above it; empty if the figure has no other picture
 * @param picture without its title
 */
public record Panel(String title, Picture picture) {}
