// SPDX-License-Identifier: Apache-2.0
/**
 * The arrays that hold a scene and its motion: circles, obstacles, ids, rows of the log, recorded
 * flights, what an unfinished step takes back.
 */
package dev.carom.internal.state;
