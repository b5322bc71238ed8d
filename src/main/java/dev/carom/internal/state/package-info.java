// SPDX-License-Identifier: Apache-2.0
/**
 * The arrays that hold a scene and its motion: circles, obstacles, ids, rows of the log, recorded
 * flights, and the undo log of a step.
 */
package dev.carom.internal.state;
