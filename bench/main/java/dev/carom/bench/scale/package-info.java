// SPDX-License-Identifier: Apache-2.0
/** How the time of a frame, and memory, grow with the number of circles. */
package dev.carom.bench.scale;
