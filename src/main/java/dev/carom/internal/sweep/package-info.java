// SPDX-License-Identifier: Apache-2.0
/**
 * The time at which a moving disk meets a line's side, an endpoint, a wall or another disk: in
 * plain doubles with proven bounds, and by exact arithmetic where the bounds leave doubt.
 */
package dev.carom.internal.sweep;
