// SPDX-License-Identifier: Apache-2.0
/**
 * The exact oracle: what the right answer to a question about contact is, in real arithmetic.
 *
 * <p>Nothing here uses the library. {@link dev.carom.oracle.Oracle} is the definition of contact
 * written down over exact numbers: dyadic ones ({@link dev.carom.oracle.Dyadic}) and signs of
 * {@code x + y sqrt(z)} ({@link dev.carom.oracle.Surd}). {@link dev.carom.oracle.Families} asks the
 * questions, {@link dev.carom.oracle.Judge} compares.
 */
package dev.carom.oracle;
