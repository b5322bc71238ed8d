// SPDX-License-Identifier: Apache-2.0

/** Benchmarks of single operations, for JMH's own command line. */
package dev.carom.bench.jmh;
