// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Feature;

/**
 * The first contact of a flight with something.
 *
 * @param after how long after the question's start
 * @param feature what is hit
 * @param overlapping whether there was contact at the start already: then the time is 0 however the
 *     start changes
 */
record Touch(Ball after, Feature feature, boolean overlapping) {}
