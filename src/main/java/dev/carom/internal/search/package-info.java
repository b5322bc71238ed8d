// SPDX-License-Identifier: Apache-2.0
/** Which obstacle a flight hits first: the static grid, the broad phase and the narrow phase. */
package dev.carom.internal.search;
