// SPDX-License-Identifier: Apache-2.0
/**
 * The event engine: steps of circles that ignore each other and of circles that collide, and edits
 * between steps.
 */
package dev.carom.internal.engine;
