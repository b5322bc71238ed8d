// SPDX-License-Identifier: Apache-2.0
/**
 * Which obstacle a flight meets first: the grid of what stands still, the broad and the narrow
 * phase.
 */
package dev.carom.internal.search;
