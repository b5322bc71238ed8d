// SPDX-License-Identifier: Apache-2.0
/**
 * What was measured, in one tidy table: every number a {@link dev.carom.bench.results.Row}, which
 * files, charts and sentences are made from.
 */
package dev.carom.bench.results;
