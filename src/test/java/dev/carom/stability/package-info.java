// SPDX-License-Identifier: Apache-2.0
/**
 * Causes that break collision code: CausesTest shows for each how a naive method fails, then the
 * answer of Carom. The others play what has no naive answer:
 *
 * <ul>
 *   <li>numbers: MagnitudeTest; any doubles at all: ExtremeQuestionsTest, ExtremeWorldsTest
 *   <li>without end: TrappedTest, BumpersTest, JammedCirclesTest (and EndsTest, InelasticTest)
 *   <li>masses that nothing deflects: InfiniteMassTest
 * </ul>
 *
 * The tests use public types alone.
 */
package dev.carom.stability;
