// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.bench.reference.Reference;
import java.util.Optional;

/**
 * A scene to measure on.
 *
 * @param name what tables call it
 * @param scene the scene at time 0
 * @param frames how many frames are played
 * @param reference its true course, if it is known, of at least as many frames
 */
record Subject(String name, Scene scene, int frames, Optional<Reference> reference) {}
