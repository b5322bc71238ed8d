// SPDX-License-Identifier: Apache-2.0
/** Random worlds and queries of the kinds that break things, and what must hold for each. */
package dev.carom.bench.fuzz;
