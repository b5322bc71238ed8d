// SPDX-License-Identifier: Apache-2.0
/**
 * When a moving disk meets a side, an end, a wall or another disk: in plain doubles with proven
 * bounds, exactly where these leave doubt.
 */
package dev.carom.internal.sweep;
