// SPDX-License-Identifier: Apache-2.0
/** What really happens in a scene: event-driven runs in arbitrary precision, to compare with. */
package dev.carom.bench.reference;
