// SPDX-License-Identifier: Apache-2.0
/**
 * The report: figures with captions and tables, a verdict made by rule, and the page that shows
 * them, from stored results and nothing else.
 */
package dev.carom.bench.report;
