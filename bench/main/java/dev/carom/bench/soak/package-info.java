// SPDX-License-Identifier: Apache-2.0
/** Very long runs: whether anything gets through, leaks, drifts or slows down. */
package dev.carom.bench.soak;
