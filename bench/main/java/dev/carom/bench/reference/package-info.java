// SPDX-License-Identifier: Apache-2.0
/** True courses to compare with: event-driven runs in arbitrary precision. */
package dev.carom.bench.reference;
