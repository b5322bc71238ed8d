// SPDX-License-Identifier: Apache-2.0

/** How often the detector needs more precision than plain doubles have, by family of queries. */
package dev.carom.bench.rungs;
