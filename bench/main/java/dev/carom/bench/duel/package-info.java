// SPDX-License-Identifier: Apache-2.0
/**
 * Side by side: this library and another method play the same scene from the same moment, frame by
 * frame, and each frame is kept with the failures up to it.
 */
package dev.carom.bench.duel;
