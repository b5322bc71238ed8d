// SPDX-License-Identifier: Apache-2.0
/** Stepping: circles that ignore each other, circles that collide, and edits between steps. */
package dev.carom.internal.engine;
