// SPDX-License-Identifier: Apache-2.0

/**
 * What the harness compares: ways to move the circles of a scene frame by frame. A method is built
 * from a scene, outside of what is timed, and then asked for one frame after the other.
 */
package dev.carom.bench.methods;
