// SPDX-License-Identifier: Apache-2.0
/**
 * Measures of methods and peers, each a class that makes rows: errors of one frame, how long a run
 * stays near the true course, wrong decisions, lost energy, penetration, work, and time. {@link
 * dev.carom.bench.measures.Parts} cuts all of it into parts that can be run one by one. {@link
 * dev.carom.bench.measures.RungSurvey} counts how often the detector needs more precision than
 * plain doubles have.
 */
package dev.carom.bench.measures;
