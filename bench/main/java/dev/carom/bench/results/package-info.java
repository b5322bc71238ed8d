// SPDX-License-Identifier: Apache-2.0
/**
 * All measurements in one tidy table: every number is a {@link dev.carom.bench.results.Row}. Files,
 * charts and sentences are made from the rows.
 */
package dev.carom.bench.results;
