// SPDX-License-Identifier: Apache-2.0

/**
 * Causes that break collision code, one by one: each test shows first how a naive method fails,
 * then the answer of Carom. The tests use public types alone.
 *
 * <ul>
 *   <li>fast: TunnellingTest; just touching: GrazingTest; which part: EndpointOrSideTest
 *   <li>lines together: JointTest, CornerTest (and WedgeTest), CorridorTest, DegenerateLinesTest
 *   <li>at rest: RestingTest, LatticeTest (and RestTest, CradleTest); started inside: OverlapTest
 *   <li>many at once: SimultaneousTest; without end: CollapseTest (and EndsTest, InelasticTest)
 *   <li>numbers: MagnitudeTest, MassAndSizeTest (and GalperinTest), RestitutionTest, TimeStepTest
 *   <li>any doubles at all: ExtremeQuestionsTest, ExtremeWorldsTest
 *   <li>refusals: NothingHalfDoneTest (and RefusedEditTest)
 * </ul>
 */
package dev.carom.stability;
