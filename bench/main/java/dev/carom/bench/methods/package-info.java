// SPDX-License-Identifier: Apache-2.0

/**
 * The methods that the harness compares: ways to move the circles of a scene frame by frame. A
 * method is built from a scene, which is not timed, and then asked for one frame after the other.
 */
package dev.carom.bench.methods;
