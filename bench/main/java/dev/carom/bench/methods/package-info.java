// SPDX-License-Identifier: Apache-2.0

/**
 * The methods that the harness compares: ways to move the circles of a scene frame by frame. A
 * method is built from a scene, which is not timed, and then asked for one frame after the other.
 *
 * <p>The published algorithm and the textbooks' one are compared in double and in float. Their
 * sources are in double. The build makes the classes in float from them, by another name for the
 * type: {@code FloatPoster} is {@code Poster} with every double a float, but for the numbers that
 * {@link dev.carom.bench.methods.Method} answers.
 */
package dev.carom.bench.methods;
