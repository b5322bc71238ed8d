// SPDX-License-Identifier: Apache-2.0
/** Finds the first obstacle of a flight: static grid, broad phase and narrow phase. */
package dev.carom.internal.search;
